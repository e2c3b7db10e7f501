// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every segmentation of a graph guarantees.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_SEGMENTS_OF_GRAPHS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_SEGMENTS_OF_GRAPHS_H

#include "check.h"
#include "dual_graphs.h"
#include "validation.h"

#include <cstddef>
#include <vector>

namespace test_meshes {

// Checks that every segment has nodes and is connected.
inline void check_segments(const Dual_graph& graph, const std::vector<Index>& labels, std::size_t number)
{
  std::vector<std::vector<std::size_t>> neighbors(graph.number_of_nodes());
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    for (const Index arc : graph.arcs(i))
      neighbors[i].push_back(graph.target[arc]);
  const std::vector<std::size_t> ids(labels.begin(), labels.end());
  CGAL_CHECK_EQUAL(validation::problem_with_segment_ids(ids, number).value_or("no problem"), "no problem");
  const std::vector<bool> is_on_speck(ids.size(), false);
  CGAL_CHECK_EQUAL(
    validation::problem_with_connectedness(neighbors, is_on_speck, ids, number).value_or("no problem"),
    "no problem");
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_SEGMENTS_OF_GRAPHS_H
