// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_COARSE_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_COARSE_GRAPH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/coarsen_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/disk_clusters.h>

#include <numeric>
#include <utility>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The graph of the disk clusters of a graph.
inline Coarse_graph contract_disks(const Weighted_dual_graph& graph,
                                   Weighted_dual_graph::Index largest_number,
                                   Execution& execution)
{
  Clusters clusters = Disk_clusters(graph)(largest_number, execution);
  Coarse_graph result;
  result.graph = Graph_contraction(graph, clusters.of_node, clusters.number, execution.is_parallel())();
  result.graph.length = lengths_between_centres(result.graph, execution.is_parallel());
  result.node = std::move(clusters.of_node);
  return result;
}

// The graph that cuts are searched on: about two thousand nodes that do not straddle seams. The structure of a shape
// of up to some dozen parts shows in that many; cuts get worse with more, since details come to the fore. A graph with
// no more nodes stays as it is.
//
// Of a large graph the nodes are first merged to groups that are small against a disk: clusters of these are as steady,
// and take no longer for any number of faces.
inline Coarse_graph make_coarse_graph(const Weighted_dual_graph& graph, Execution& execution)
{
  using Index = Weighted_dual_graph::Index;
  constexpr Index number_of_nodes = 2000;
  constexpr Index largest_number_of_nodes = 2 * number_of_nodes;
  constexpr Index number_of_groups = 40 * number_of_nodes;

  if (graph.number_of_nodes() <= number_of_nodes)
  {
    Coarse_graph same{graph, std::vector<Index>(graph.number_of_nodes())};
    std::iota(same.node.begin(), same.node.end(), Index(0));
    same.graph.concave_border_length.clear();
    for (Index arc = 0; arc < graph.target.size(); ++arc)
      same.graph.concave_border_length.push_back(graph.concave_border(arc));
    return same;
  }
  if (graph.number_of_nodes() <= number_of_groups)
    return contract_disks(graph, largest_number_of_nodes, execution);
  Coarse_graph groups = coarsen(graph, number_of_groups, execution);
  Coarse_graph result = contract_disks(groups.graph, largest_number_of_nodes, execution);
  for (Index& node : groups.node)
    node = result.node[node];
  result.node = std::move(groups.node);
  return result;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_COARSE_GRAPH_H
