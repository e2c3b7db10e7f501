// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Costs of cuts by their definition.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_COSTS_OF_CUTS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_COSTS_OF_CUTS_H

#include "dual_graphs.h"

#include <vector>

namespace test_meshes {

// `inner`: whether each node lies on the inner side
inline double cost_of(const Seam_graph& graph, const std::vector<bool>& inner)
{
  double cost = 0;
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    for (const Index arc : graph.arcs(i))
      if (inner[i] && !inner[graph.target[arc]])
        cost += graph.capacity[arc];
  return cost;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_COSTS_OF_CUTS_H
