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

// A graph with no more nodes stays as it is; one with more than the second is divided into groups first.
constexpr Weighted_dual_graph::Index number_of_nodes_of_coarse_graph = 2000;
constexpr Weighted_dual_graph::Index number_of_groups = 80000; // forty in a disk

// The disks of a graph, which may not be weighed yet.
inline Disk_clusters select_disks(const Weighted_dual_graph& graph, Execution& execution)
{
  Disk_clusters disks(graph);
  disks.select_seeds(2 * number_of_nodes_of_coarse_graph, execution);
  return disks;
}

// Whether the coarse graph of a graph is that of its own disks: else it is the graph itself, or that of disks of groups.
inline bool has_disks_of_nodes(const Weighted_dual_graph& graph)
{
  return graph.number_of_nodes() > number_of_nodes_of_coarse_graph && graph.number_of_nodes() <= number_of_groups;
}

// Of a large graph the nodes are merged to groups that are small against a disk: clusters of these are as steady, and take
// no longer for any number of faces. None of a graph that is not larger.
inline std::optional<Coarse_graph> make_groups(const Weighted_dual_graph& graph, Execution& execution)
{
  if (graph.number_of_nodes() <= number_of_groups)
    return std::nullopt;
  return coarsen(graph, number_of_groups, execution);
}

// The graph of disks of groups.
inline Coarse_graph contract_groups(const Coarse_graph& groups, Execution& execution)
{
  using Index = Weighted_dual_graph::Index;
  Coarse_graph result =
    contract(groups.graph, select_disks(groups.graph, execution).clusters(), execution.is_parallel());
  const std::vector<Index> node_of_group = std::move(result.node);
  result.node.clear();
  result.node.reserve(groups.node.size());
  for (Index group : groups.node)
    result.node.push_back(node_of_group[group]);
  return result;
}

// The graph that cuts are searched on: about two thousand nodes that do not straddle seams. The structure of a shape
// of up to some dozen parts shows in that many; cuts get worse with more, since details come to the fore. `disks` and
// `groups`: those of the graph, if there are any
inline Coarse_graph make_coarse_graph(const Weighted_dual_graph& graph,
                                      std::optional<Disk_clusters> disks,
                                      const std::optional<Coarse_graph>& groups,
                                      Execution& execution)
{
  using Index = Weighted_dual_graph::Index;
  if (groups)
    return contract_groups(*groups, execution);
  if (disks)
    return contract(graph, disks->clusters(), execution.is_parallel());
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
