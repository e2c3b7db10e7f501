// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds for all graphs of surfaces.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_CHECKS_OF_GRAPHS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_CHECKS_OF_GRAPHS_H

#include "check.h"
#include "dual_graphs.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace test_meshes {

// Checks that all arcs between two nodes together weigh the same in both directions.
inline void check_symmetry(const Seam_graph& graph)
{
  std::map<std::pair<Index, Index>, std::array<double, 3>> weights;
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    for (const Index arc : graph.arcs(i))
    {
      std::array<double, 3>& sum = weights[{i, graph.target[arc]}];
      sum[0] += graph.capacity[arc];
      sum[1] += graph.length[arc];
      sum[2] += graph.border_length[arc];
      CGAL_CHECK(graph.capacity[arc] <= graph.border_length[arc] * (1 + 1e-6));
      CGAL_CHECK(graph.seam_length(arc) >= graph.length[arc]);
      CGAL_CHECK(graph.length_in_seam(arc) <= graph.border_length[arc] * (1 + 1e-6));
    }
  for (const auto& [arc, sum] : weights)
  {
    const auto opposite = weights.find({arc.second, arc.first});
    CGAL_CHECK(opposite != weights.end());
    if (opposite != weights.end())
      for (int i = 0; i < 3; ++i)
        CGAL_CHECK_CLOSE(opposite->second[i], sum[i], 1e-6);
  }
}

inline double sum(const std::vector<float>& values)
{
  double result = 0;
  for (const float value : values)
    result += value;
  return result;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_CHECKS_OF_GRAPHS_H
