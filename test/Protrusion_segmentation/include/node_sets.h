// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes of a graph as sets, for comparisons with brute force.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_NODE_SETS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_NODE_SETS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>

#include <set>

namespace test_meshes {

using Node_set = std::set<CGAL::Protrusion_segmentation::internal::Dual_graph::Index>;

inline double area_of(const CGAL::Protrusion_segmentation::internal::Dual_graph& graph,
                      const Node_set& nodes)
{
  double area = 0;
  for (const auto i : nodes)
    area += graph.area[i];
  return area;
}

// Whether some nodes, at least one, are connected with each other.
inline bool are_connected(CGAL::Protrusion_segmentation::internal::Graph_partition& partition,
                          const CGAL::Protrusion_segmentation::internal::Nodes& nodes)
{
  const Node_set set(nodes.begin(), nodes.end());
  return partition.connected_nodes(nodes.front(), [&](auto i) { return set.count(i) != 0; }).size() == set.size();
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_NODE_SETS_H
