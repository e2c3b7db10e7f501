// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CONTRACT_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CONTRACT_GRAPH_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/match_neighbors.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

template <typename T>
void append_to(std::vector<T>& all, const std::vector<T>& more)
{
  all.insert(all.end(), more.begin(), more.end());
}

// The arcs between sets of nodes: one for all arcs between the nodes of the two.
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

  // Appends to `first_arc` and `target`. `add(sum, arc)` adds an arc of nodes, at first to `Sum()`; `append(sums)` is
  // called with those of some arcs, of all in the end, in the order of the arcs.
  template <typename Add, typename Append>
  void operator()(std::vector<Index>& first_arc, std::vector<Index>& target, bool is_parallel, Add add, Append append) const
  {
    // more than needed, but memory that is not written to costs nothing, and growing would hold all twice
    first_arc.reserve(m_sets.number_of_groups() + 1);
    target.reserve(m_target.size());
    // Several blocks of sets at a time are merged by several threads and put behind those before: so many that threads
    // have something to do, so few that they take little memory.
    constexpr std::size_t blocks_of_round = 64;
    std::vector<Index> place(m_sets.number_of_groups(), 0);
    std::vector<Block> blocks(is_parallel ? blocks_of_round : 1);
    const std::size_t all = number_of_blocks(m_sets.number_of_groups());
    for (std::size_t first = 0; first < all; first += blocks.size())
    {
      const std::size_t number = (std::min)(blocks.size(), all - first);
      for_each_index(
        number, is_parallel, place,
        [&](std::vector<Index>& own_place, std::size_t b) { merge_block(first + b, own_place, blocks[b], add); },
        [](const std::vector<Index>&) {});
      for (std::size_t b = 0; b < number; ++b)
      {
        for (Index end : blocks[b].end)
          first_arc.push_back(static_cast<Index>(target.size()) + end);
        append_to(target, blocks[b].target);
        append(blocks[b].sums);
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

  // `place`: a work array, of every set; what is in it does not matter.
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
            // unless the set has an arc to v
            if (!(place[v] >= begin && place[v] < arcs.target.size() && arcs.target[place[v]] == v))
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

// Tied nodes with their arrays.
struct Tie_graph
{
  using Index = Tied_nodes::Index;

  std::vector<Index> first_arc = std::vector<Index>(1, 0);
  std::vector<Index> target;
  std::vector<float> tie;
  std::vector<double> area;

  Tied_nodes nodes() const { return {first_arc, target, tie, area}; }
};

// Makes tied nodes of sets of others, without what else a graph has: ties add up. `number`: of the set, below `count`, of
// every node
inline Tie_graph contract_ties(const Tied_nodes& nodes,
                               const std::vector<Tied_nodes::Index>& number,
                               Tied_nodes::Index count,
                               bool is_parallel)
{
  using Index = Tied_nodes::Index;
  const Index_groups sets(number, count);
  Tie_graph result;
  result.area.resize(count);
  for_each_block(count, is_parallel,
                 [&](std::size_t begin, std::size_t end, std::size_t)
                 {
                   for (std::size_t u = begin; u < end; ++u)
                     for (Index i : sets[u])
                       result.area[u] += nodes.area[i];
                 });
  result.tie.reserve(nodes.tie.size());
  Arc_merger<float>(nodes.first_arc, nodes.target, number, sets)(
    result.first_arc, result.target, is_parallel, [&](float& sum, Index arc) { sum += nodes.tie[arc]; },
    [&](const std::vector<float>& sums) { append_to(result.tie, sums); });
  return result;
}

// Makes one graph of another, whose nodes are sets of nodes of that, still without lengths. Border lengths and
// capacities add up; curvatures are averaged along the borders.
class Graph_contraction
{
public:
  using Index = Weighted_dual_graph::Index;

  // `number`: of the set, below `count`, of every node
  Graph_contraction(const Weighted_dual_graph& graph, const std::vector<Index>& number, Index count, bool is_parallel)
    : m_graph(graph),
      m_number(number),
      m_sets(number, count),
      m_is_parallel(is_parallel),
      m_has_seams(!graph.capacity.empty())
  {}

  Weighted_dual_graph operator()()
  {
    m_result.length_of_angle = m_graph.length_of_angle;
    m_result.is_flat = m_graph.is_flat;
    m_result.area.resize(m_sets.number_of_groups());
    m_result.centre.resize(m_sets.number_of_groups());
    for_each_block(m_sets.number_of_groups(), m_is_parallel,
                   [this](std::size_t begin, std::size_t end, std::size_t)
                   {
                     for (std::size_t u = begin; u < end; ++u)
                       merge_nodes(static_cast<Index>(u));
                   });
    Arc_merger<Border>(m_graph.first_arc, m_graph.target, m_number, m_sets)(
      m_result.first_arc, m_result.target, m_is_parallel, [this](Border& border, Index arc) { add(border, arc); },
      [this](const std::vector<Border>& borders) { append(borders); });
    return std::move(m_result);
  }

private:
  struct Border
  {
    float length = 0, concave_length = 0, capacity = 0, curvature = 0; // the last times the length
  };

  void merge_nodes(Index u)
  {
    const Indexed_surface::Point_3 origin(0, 0, 0);
    Indexed_surface::Vector_3 moment(0, 0, 0);
    double area = 0;
    for (Index i : m_sets[u])
    {
      area += m_graph.area[i];
      moment += m_graph.area[i] * (m_graph.centre_of(i) - origin);
    }
    m_result.area[u] = area;
    m_result.set_centre(u, area > 0 ? origin + moment / area : m_graph.centre_of(m_sets[u].front()));
  }

  void add(Border& border, Index arc) const
  {
    border.length += m_graph.border_length[arc];
    if (!m_has_seams)
      return;
    border.concave_length += m_graph.concave_border(arc);
    border.capacity += m_graph.capacity[arc];
    border.curvature += m_graph.curvature[arc] * m_graph.border_length[arc];
  }

  void append(const std::vector<Border>& borders)
  {
    for (const Border& border : borders)
    {
      m_result.border_length.push_back(border.length);
      if (!m_has_seams)
        continue;
      m_result.concave_border_length.push_back(border.concave_length);
      m_result.capacity.push_back(border.capacity);
      m_result.curvature.push_back(border.length > 0 ? border.curvature / border.length : border.curvature);
    }
  }

  const Weighted_dual_graph& m_graph;
  const std::vector<Index>& m_number;
  Index_groups m_sets;
  bool m_is_parallel;
  bool m_has_seams; // what is computed from curvatures, which are not known when normals are averaged
  Weighted_dual_graph m_result;
};

// The distances between the centres of neighbouring nodes.
inline std::vector<float> lengths_between_centres(const Weighted_dual_graph& graph, bool is_parallel)
{
  using Index = Weighted_dual_graph::Index;
  std::vector<float> lengths(graph.target.size());
  for_each_block(graph.number_of_nodes(), is_parallel,
                 [&](std::size_t begin, std::size_t end, std::size_t)
                 {
                   for (std::size_t i = begin; i < end; ++i)
                     for (Index arc : graph.arcs(static_cast<Index>(i)))
                     {
                       const Indexed_surface::Vector_3 step =
                         graph.centre_of(graph.target[arc]) - graph.centre_of(static_cast<Index>(i));
                       lengths[arc] = static_cast<float>((std::max)(std::sqrt(step.squared_length()), 1e-9));
                     }
                 });
  return lengths;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CONTRACT_GRAPH_H
