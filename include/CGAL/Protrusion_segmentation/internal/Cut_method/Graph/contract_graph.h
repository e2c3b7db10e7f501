// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_CONTRACT_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_CONTRACT_GRAPH_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Thread_workspaces.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Sets of nodes, each connected: of every node the number of its set, below `number`.
struct Clusters
{
  std::vector<Dual_graph::Index> of_node;
  Dual_graph::Index number = 0;
};

// Merges the arcs between sets of nodes: one for all arcs between the nodes of the two.
//
// `Sum`: what is known of an arc between sets while arcs of nodes are added to it
template <typename Sum>
class Arc_merger
{
public:
  using Index = Indexed_surface::Index;

  // `number`: of the set of every node
  Arc_merger(const std::vector<Index>& first_arc,
             const std::vector<Index>& target,
             const std::vector<Index>& number,
             const Index_groups& sets)
    : m_first_arc(first_arc), m_target(target), m_number(number), m_sets(sets)
  {}

  // Appends to `first_arc` and `target`. `add(sum, arc)` adds an arc of nodes, at first to `Sum()`; `append(sum)` is called with
  // that of each arc, in their order.
  template <typename Add, typename Append>
  void operator()(std::vector<Index>& first_arc, std::vector<Index>& target, bool is_parallel, Add add, Append append) const
  {
    // more than needed, but memory that is not written to costs nothing, and growing would hold all twice
    first_arc.reserve(m_sets.number_of_groups() + 1);
    target.reserve(m_target.size());
    // Some blocks of sets are merged side by side, then appended: enough for many threads, few enough for little memory.
    constexpr std::size_t blocks_of_round = 64;
    Thread_workspaces<std::vector<Index>> places(m_sets.number_of_groups(), 0);
    std::vector<Block> blocks(is_parallel ? blocks_of_round : 1);
    const std::size_t all = number_of_blocks(m_sets.number_of_groups());
    for (std::size_t first = 0; first < all; first += blocks.size())
    {
      const std::size_t number = (std::min)(blocks.size(), all - first);
      places.for_each_index(number, is_parallel, [&](std::vector<Index>& place, std::size_t b)
                            { merge_block(first + b, place, blocks[b], add); });
      for (std::size_t b = 0; b < number; ++b)
      {
        for (Index end : blocks[b].end)
          first_arc.push_back(static_cast<Index>(target.size()) + end);
        target.insert(target.end(), blocks[b].target.begin(), blocks[b].target.end());
        for (const Sum& sum : blocks[b].sums)
          append(sum);
      }
    }
  }

private:
  // The arcs of some sets, one after the other.
  struct Block
  {
    std::vector<Index> end; // of every set
    std::vector<Index> target;
    std::vector<Sum> sums;
  };

  // `place`: a work array, of every set; its contents do not matter.
  template <typename Add>
  void merge_block(std::size_t block, std::vector<Index>& place, Block& arcs, Add add) const
  {
    arcs.end.clear();
    arcs.target.clear();
    arcs.sums.clear();
    const std::size_t end = (std::min)((block + 1) * indices_of_block, std::size_t(m_sets.number_of_groups()));
    for (std::size_t u = block * indices_of_block; u < end; ++u)
    {
      const std::size_t begin = arcs.target.size();
      for (Index i : m_sets[u])
        for (Index old = m_first_arc[i]; old < m_first_arc[i + 1]; ++old)
          if (const Index v = m_number[m_target[old]]; v != u)
          {
            const bool is_known = place[v] >= begin && place[v] < arcs.target.size() && arcs.target[place[v]] == v;
            if (!is_known)
            {
              place[v] = static_cast<Index>(arcs.target.size());
              arcs.target.push_back(v);
              arcs.sums.emplace_back();
            }
            add(arcs.sums[place[v]], old);
          }
      arcs.end.push_back(static_cast<Index>(arcs.target.size()));
    }
  }

  const std::vector<Index>& m_first_arc;
  const std::vector<Index>& m_target;
  const std::vector<Index>& m_number;
  const Index_groups& m_sets;
};

// A graph whose nodes are sets of nodes of another one.
template <typename Graph>
struct Contracted
{
  Graph graph;
  Centres centre;                       // of every node
  std::vector<Dual_graph::Index> node; // for every node of the other graph
};

// Between the nodes of a contracted graph.
struct Merged_border
{
  float length = 0, concave_length = 0, folded_length = 0, capacity = 0, curvature = 0; // the last times the length
};

// The lengths of the arcs between the centres of neighbouring nodes.
inline void measure_lengths(Dual_graph& graph, const Centres& centre, bool is_parallel)
{
  using Index = Dual_graph::Index;
  constexpr double least_length = 1e-9;
  graph.length.resize(graph.target.size());
  for_each_number(graph.number_of_nodes(), is_parallel,
                  [&](Index i)
                  {
                    for (Index arc : graph.arcs(i))
                    {
                      const double squared = (point(centre[graph.target[arc]]) - point(centre[i])).squared_length();
                      graph.length[arc] = static_cast<float>((std::max)(std::sqrt(squared), least_length));
                    }
                  });
}

// The graph of some sets: border lengths and capacities add up, curvatures are averaged along the borders.
//
// `Graph`: a dual graph, or one with seams
template <typename Graph>
Contracted<Graph> contract(const Graph& graph, const Centres& centre_of_node, Clusters clusters, bool is_parallel)
{
  using Index = Dual_graph::Index;
  constexpr bool has_seams = std::is_base_of<Seam_graph, Graph>::value;
  const Index_groups sets(clusters.of_node, clusters.number);
  Contracted<Graph> result;
  result.graph.area.resize(clusters.number);
  result.centre.resize(clusters.number);
  for_each_number(clusters.number, is_parallel,
                  [&](Index u)
                  {
                    const Indexed_surface::Point_3 origin(0, 0, 0);
                    Indexed_surface::Vector_3 moment(0, 0, 0);
                    double area = 0;
                    for (Index i : sets[u])
                    {
                      area += graph.area[i];
                      moment += graph.area[i] * (point(centre_of_node[i]) - origin);
                    }
                    result.graph.area[u] = area;
                    result.centre[u] = area > 0 ? centre(origin + moment / area) : centre_of_node[sets[u].front()];
                  });
  const auto add = [&graph](Merged_border& border, Index arc)
  {
    border.length += graph.border_length[arc];
    if constexpr (has_seams)
    {
      border.concave_length += graph.length_in_seam(arc);
      border.folded_length += graph.length_in_fold(arc);
      border.capacity += graph.capacity[arc];
      border.curvature += graph.curvature[arc] * graph.border_length[arc];
    }
  };
  const auto append = [&to = result.graph](const Merged_border& border)
  {
    to.border_length.push_back(border.length);
    if constexpr (has_seams)
    {
      to.concave_length.push_back(border.concave_length);
      to.folded_length.push_back(border.folded_length);
      to.capacity.push_back(border.capacity);
      to.curvature.push_back(border.length > 0 ? border.curvature / border.length : border.curvature);
    }
  };
  Arc_merger<Merged_border>(graph.first_arc, graph.target, clusters.of_node, sets)(
    result.graph.first_arc, result.graph.target, is_parallel, add, append);
  measure_lengths(result.graph, result.centre, is_parallel);
  if constexpr (has_seams)
    result.graph.outward = graph.outward;
  result.node = std::move(clusters.of_node);
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_CONTRACT_GRAPH_H
