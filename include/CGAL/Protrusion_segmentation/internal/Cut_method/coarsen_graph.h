// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COARSEN_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COARSEN_GRAPH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/contract_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/match_neighbors.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A coarse graph and the node of it that every node of the original graph went into.
struct Coarse_graph
{
  Weighted_dual_graph graph;
  std::vector<Weighted_dual_graph::Index> node;
};

// Sets of nodes, each connected: of every node the number of its set, below `number`.
struct Clusters
{
  std::vector<Weighted_dual_graph::Index> of_node;
  Weighted_dual_graph::Index number = 0;
};

// The graph of some sets, with lengths.
inline Coarse_graph contract(const Weighted_dual_graph& graph, Clusters sets, bool is_parallel)
{
  Coarse_graph result;
  result.graph = Graph_contraction(graph, sets.of_node, sets.number, is_parallel)();
  result.graph.length = lengths_between_centres(result.graph, is_parallel);
  result.node = std::move(sets.of_node);
  return result;
}

// Joins neighbours, two and two, again and again, until there are about `number` sets of similar areas.
inline Clusters join_neighbors(const Tied_nodes& all, Tied_nodes::Index number, Execution& execution)
{
  using Index = Tied_nodes::Index;
  // twice the mean; larger sets would hide narrow protrusions
  const double largest_area = 2. / number;
  // a round that joins less than this share of the sets is the last
  constexpr double least_progress = 0.02;
  Clusters result;
  result.number = all.number_of_nodes();
  Tie_graph sets; // after the last round
  while (result.number > number)
  {
    execution.check();
    const Tied_nodes current = result.of_node.empty() ? all : sets.nodes();
    auto [pair, count] = Neighbor_matcher(current, largest_area)(result.number - number, execution.is_parallel());
    if (count == result.number || (result.number - count < least_progress * result.number && result.number < 2 * number))
      break;
    if (count > number)
      sets = contract_ties(current, pair, count, execution.is_parallel());
    if (result.of_node.empty())
      result.of_node = std::move(pair);
    else
      for_each_block(result.of_node.size(), execution.is_parallel(),
                     [&result, &pair = pair](std::size_t begin, std::size_t end, std::size_t)
                     {
                       for (std::size_t i = begin; i < end; ++i)
                         result.of_node[i] = pair[result.of_node[i]];
                     });
    result.number = count;
  }
  if (result.of_node.empty())
  {
    result.of_node.resize(all.number_of_nodes());
    std::iota(result.of_node.begin(), result.of_node.end(), Index(0));
  }
  return result;
}

// Contracts a graph to about `number_of_nodes` nodes of similar area that do not straddle seams, in linear time. `tie`
// is what holds neighbours together.
inline Coarse_graph coarsen(const Weighted_dual_graph& graph,
                            Weighted_dual_graph::Index number_of_nodes,
                            Execution& execution,
                            std::vector<float> Weighted_dual_graph::*tie = &Weighted_dual_graph::capacity)
{
  return contract(graph, join_neighbors({graph.first_arc, graph.target, graph.*tie, graph.area}, number_of_nodes, execution),
                  execution.is_parallel());
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COARSEN_GRAPH_H
