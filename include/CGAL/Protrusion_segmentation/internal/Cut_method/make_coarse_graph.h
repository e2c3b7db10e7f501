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
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The graph of the disk clusters of a graph.
inline Coarse_graph contract_disks(const Weighted_dual_graph& graph,
                                   Weighted_dual_graph::Index largest_number,
                                   Execution& execution)
{
  return contract(graph, Disk_clusters(graph)(largest_number, execution), execution.is_parallel());
}

// Of a large graph the nodes are merged to groups that are small against a disk: clusters of these are as steady, and take
// no longer for any number of faces. None of a graph that is not larger.
inline std::optional<Coarse_graph> make_groups(const Weighted_dual_graph& graph, Execution& execution)
{
  constexpr Weighted_dual_graph::Index number_of_groups = 80000; // forty in a disk
  if (graph.number_of_nodes() <= number_of_groups)
    return std::nullopt;
  return coarsen(graph, number_of_groups, execution);
}

// The graph that cuts are searched on: about two thousand nodes that do not straddle seams. The structure of a shape
// of up to some dozen parts shows in that many; cuts get worse with more, since details come to the fore. A graph with
// no more nodes stays as it is. `groups`: those of the graph, if there are any
inline Coarse_graph make_coarse_graph(const Weighted_dual_graph& graph,
                                      const std::optional<Coarse_graph>& groups,
                                      Execution& execution)
{
  using Index = Weighted_dual_graph::Index;
  constexpr Index number_of_nodes = 2000;
  constexpr Index largest_number_of_nodes = 2 * number_of_nodes;

  if (groups)
  {
    Coarse_graph result = contract_disks(groups->graph, largest_number_of_nodes, execution);
    const std::vector<Index> node_of_group = std::move(result.node);
    result.node.clear();
    result.node.reserve(groups->node.size());
    for (Index group : groups->node)
      result.node.push_back(node_of_group[group]);
    return result;
  }
  if (graph.number_of_nodes() > number_of_nodes)
    return contract_disks(graph, largest_number_of_nodes, execution);
  Coarse_graph same{graph, std::vector<Index>(graph.number_of_nodes())};
  std::iota(same.node.begin(), same.node.end(), Index(0));
  same.graph.concave_border_length.clear();
  for (Index arc = 0; arc < graph.target.size(); ++arc)
    same.graph.concave_border_length.push_back(graph.concave_border(arc));
  return same;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_COARSE_GRAPH_H
