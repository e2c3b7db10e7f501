// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_COARSEN_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_COARSEN_GRAPH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/contract_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/match_neighbors.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Contracts affinities: those between the nodes of two sets add up.
inline Affinity_graph contract_affinities(const Affinities& nodes, const std::vector<Affinities::Index>& number, Affinities::Index count, bool is_parallel)
{
  using Index = Affinities::Index;
  const Index_groups sets(number, count);
  Affinity_graph result;
  result.area.resize(count);
  for_each_number(count, is_parallel,
                  [&](Index u)
                  {
                    for (Index i : sets[u])
                      result.area[u] += nodes.area[i];
                  });
  result.affinity.reserve(nodes.affinity.size());
  Arc_merger<float>(nodes.first_arc, nodes.target, number, sets)(
    result.first_arc, result.target, is_parallel, [&](float& sum, Index arc) { sum += nodes.affinity[arc]; },
    [&](float sum) { result.affinity.push_back(sum); });
  return result;
}

// Joins neighbours, two and two, again and again, until there are about `number` sets of similar areas.
inline Clusters join_neighbors(const Affinities& all, Affinities::Index number, Execution& execution)
{
  using Index = Affinities::Index;
  const double largest_area = 2. / number; // twice the mean: larger sets would hide narrow protrusions
  constexpr double least_progress = 0.02;  // a round that joins less than this share of the sets is the last
  Clusters result;
  result.number = all.number_of_nodes();
  result.of_node.resize(result.number);
  std::iota(result.of_node.begin(), result.of_node.end(), Index(0));
  Affinity_graph sets; // after the last round
  bool is_first = true;
  while (result.number > number)
  {
    execution.check();
    const Affinities current = is_first ? all : sets.view();
    const auto [pair, count] = Neighbor_matcher(current, largest_area)(result.number - number, execution.is_parallel());
    if (count == result.number || (result.number - count < least_progress * result.number && result.number < 2 * number))
      break;
    if (count > number)
      sets = contract_affinities(current, pair, count, execution.is_parallel());
    for_each_number(result.of_node.size(), execution.is_parallel(),
                    [&result, &pair = pair](Index i) { result.of_node[i] = pair[result.of_node[i]]; });
    result.number = count;
    is_first = false;
  }
  return result;
}

// Contracts a graph to about `number_of_nodes` nodes of similar area, in linear time. `affinity`: an array of the graph, of
// every arc; nodes of largest affinity for their size are joined first.
template <typename Graph>
Contracted<Graph> coarsen(const Graph& graph,
                          const Centres& centre,
                          const std::vector<float>& affinity,
                          Dual_graph::Index number_of_nodes,
                          Execution& execution)
{
  return contract(graph, centre,
                  join_neighbors({graph.first_arc, graph.target, affinity, graph.area}, number_of_nodes, execution),
                  execution.is_parallel());
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_COARSEN_GRAPH_H
