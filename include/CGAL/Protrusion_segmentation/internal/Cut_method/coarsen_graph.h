// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COARSEN_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COARSEN_GRAPH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/prefetch.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Float_key.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <CGAL/number_utils.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
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

// The nodes by their areas, as far as single precision tells them apart, then by their numbers.
inline std::vector<Float_key> by_area(const Weighted_dual_graph& graph, bool is_parallel)
{
  std::vector<Float_key> keys(graph.number_of_nodes());
  for_each_block(keys.size(), is_parallel,
                 [&](std::size_t begin, std::size_t end, std::size_t)
                 {
                   for (std::size_t i = begin; i < end; ++i)
                     keys[i] = float_key(static_cast<float>(graph.area[i]), static_cast<Weighted_dual_graph::Index>(i));
                 });
  sort_different(keys, is_parallel, std::less<Float_key>(),
                 [](auto begin, auto end) { boost::sort::spreadsort::integer_sort(begin, end); });
  return keys;
}

// Pairs every node with the neighbour to which it is tied strongest for its size, small nodes first, as long
// as the pair is no larger than `largest_area`.
//
// One after the other: what is left for a node depends on those before. Nodes that follow each other by their areas lie
// anywhere in memory, so that most of the time would be waiting, if it were not asked for some nodes ahead.
class Neighbor_matcher
{
public:
  using Index = Weighted_dual_graph::Index;

  // `ties`: of every arc
  Neighbor_matcher(const Weighted_dual_graph& graph, const std::vector<float>& ties, double largest_area)
    : m_graph(graph), m_ties(ties), m_largest_area(largest_area), m_partner(graph.number_of_nodes(), unmatched)
  {}

  // Makes no more pairs than `wanted`. Returns for every node the number of its pair, and how many there are.
  std::pair<std::vector<Index>, Index> operator()(Index wanted, bool is_parallel)
  {
    const std::vector<Float_key> keys = by_area(m_graph, is_parallel);
    Index pairs = 0;
    for (std::size_t k = 0; k < keys.size() && pairs < wanted; ++k)
    {
      ask_ahead(keys, k);
      const Index i = index_of(keys[k]);
      if (m_partner[i] == unmatched)
        pairs += match(i);
    }
    return number_of_pair();
  }

private:
  static constexpr Index unmatched = Indexed_surface::no_face();

  // For a node itself, then for its arcs, then for its neighbours: each has to be there to know where the next is.
  void ask_ahead(const std::vector<Float_key>& keys, std::size_t k) const
  {
    constexpr std::size_t step = 8;
    if (k + 3 * step >= keys.size())
      return;
    const Index first = index_of(keys[k + 3 * step]);
    prefetch(&m_partner[first]);
    prefetch(&m_graph.first_arc[first]);
    prefetch(&m_graph.area[first]);
    const Index second = index_of(keys[k + 2 * step]);
    if (m_partner[second] == unmatched)
    {
      prefetch(m_graph.target.data() + m_graph.first_arc[second]);
      prefetch(m_ties.data() + m_graph.first_arc[second]);
    }
    const Index third = index_of(keys[k + step]);
    if (m_partner[third] == unmatched)
      for (Index arc : m_graph.arcs(third))
      {
        prefetch(&m_partner[m_graph.target[arc]]);
        prefetch(&m_graph.area[m_graph.target[arc]]);
      }
  }

  // Returns whether it found a partner.
  bool match(Index i)
  {
    double strongest = -1;
    for (Index arc : m_graph.arcs(i))
    {
      const Index j = m_graph.target[arc];
      if (j == i || m_partner[j] != unmatched || m_graph.area[i] + m_graph.area[j] > m_largest_area)
        continue;
      const double area = m_graph.area[i] * m_graph.area[j];
      const double strength =
        area > 0 ? CGAL::square(static_cast<double>(m_ties[arc])) / area : (std::numeric_limits<double>::max)();
      if (strength > strongest)
      {
        strongest = strength;
        m_partner[i] = j;
      }
    }
    if (m_partner[i] == unmatched)
      return false;
    m_partner[m_partner[i]] = i;
    return true;
  }

  std::pair<std::vector<Index>, Index> number_of_pair() const
  {
    std::vector<Index> number(m_partner.size(), unmatched);
    Index count = 0;
    for (Index i = 0; i < number.size(); ++i)
      if (number[i] == unmatched)
      {
        number[i] = count;
        if (m_partner[i] != unmatched)
          number[m_partner[i]] = count;
        ++count;
      }
    return {std::move(number), count};
  }

  const Weighted_dual_graph& m_graph;
  const std::vector<float>& m_ties;
  double m_largest_area;
  std::vector<Index> m_partner;
};

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
    merge_arcs();
    return std::move(m_result);
  }

private:
  // The arcs of some nodes, one after the other.
  struct Arcs
  {
    std::vector<Index> end; // of every node
    std::vector<Index> target;
    std::vector<float> border_length, concave_border_length, capacity, curvature;

    void clear()
    {
      end.clear();
      target.clear();
      for (std::vector<float>* weights : {&border_length, &concave_border_length, &capacity, &curvature})
        weights->clear();
    }
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

  // Several blocks of nodes at a time are merged by several threads and put behind those before: so many that threads
  // have something to do, so few that they take little memory.
  void merge_arcs()
  {
    constexpr std::size_t blocks_of_round = 64;
    reserve();
    std::vector<Index> place(m_sets.number_of_groups(), 0);
    std::vector<Arcs> blocks(m_is_parallel ? blocks_of_round : 1);
    const std::size_t all = number_of_blocks(m_sets.number_of_groups());
    for (std::size_t first = 0; first < all; first += blocks.size())
    {
      const std::size_t number = (std::min)(blocks.size(), all - first);
      for_each_index(
        number, m_is_parallel, place,
        [&](std::vector<Index>& place_of_arc, std::size_t block)
        { merge_arcs_of_block(first + block, place_of_arc, blocks[block]); },
        [](const std::vector<Index>&) {});
      for (std::size_t block = 0; block < number; ++block)
        append(blocks[block]);
    }
  }

  void reserve()
  {
    // more than needed, but memory that is not written to costs nothing, and growing would hold all twice
    const std::size_t n = m_graph.target.size();
    m_result.first_arc.reserve(m_sets.number_of_groups() + 1);
    m_result.target.reserve(n);
    m_result.border_length.reserve(n);
    if (m_has_seams)
      for (auto weights : {&m_result.concave_border_length, &m_result.capacity, &m_result.curvature})
        weights->reserve(n);
  }

  // `place`: a work array, of every set; what is in it does not matter.
  void merge_arcs_of_block(std::size_t block, std::vector<Index>& place, Arcs& arcs) const
  {
    arcs.clear();
    const std::size_t end = (std::min)((block + 1) * indices_of_block, std::size_t(m_sets.number_of_groups()));
    for (std::size_t u = block * indices_of_block; u < end; ++u)
    {
      const Index begin = static_cast<Index>(arcs.target.size());
      for (Index i : m_sets[u])
        for (Index old : m_graph.arcs(i))
          if (const Index v = m_number[m_graph.target[old]]; v != u)
          {
            // the arc to v, if this node has one yet
            const bool is_known = place[v] >= begin && place[v] < arcs.target.size() && arcs.target[place[v]] == v;
            if (!is_known)
              place[v] = static_cast<Index>(arcs.target.size());
            merge_arc(old, v, place[v], is_known, arcs);
          }
      for (std::size_t arc = begin; m_has_seams && arc < arcs.target.size(); ++arc)
        if (arcs.border_length[arc] > 0)
          arcs.curvature[arc] /= arcs.border_length[arc];
      arcs.end.push_back(static_cast<Index>(arcs.target.size()));
    }
  }

  void merge_arc(Index old, Index target, Index arc, bool is_known, Arcs& arcs) const
  {
    if (!is_known)
    {
      arcs.target.push_back(target);
      arcs.border_length.push_back(0);
    }
    arcs.border_length[arc] += m_graph.border_length[old];
    if (!m_has_seams)
      return;
    if (!is_known)
    {
      arcs.concave_border_length.push_back(0);
      arcs.capacity.push_back(0);
      arcs.curvature.push_back(0);
    }
    arcs.concave_border_length[arc] += m_graph.concave_border_length[old];
    arcs.capacity[arc] += m_graph.capacity[old];
    arcs.curvature[arc] += m_graph.curvature[old] * m_graph.border_length[old];
  }

  void append(const Arcs& arcs)
  {
    const Index before = static_cast<Index>(m_result.target.size());
    for (Index end : arcs.end)
      m_result.first_arc.push_back(before + end);
    const auto append_to = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
    append_to(m_result.target, arcs.target);
    append_to(m_result.border_length, arcs.border_length);
    append_to(m_result.concave_border_length, arcs.concave_border_length);
    append_to(m_result.capacity, arcs.capacity);
    append_to(m_result.curvature, arcs.curvature);
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

// Contracts a graph to about `number_of_nodes` nodes of similar area that do not straddle seams, in linear time. `tie`
// is what holds neighbours together.
inline Coarse_graph coarsen(const Weighted_dual_graph& graph,
                            Weighted_dual_graph::Index number_of_nodes,
                            Execution& execution,
                            std::vector<float> Weighted_dual_graph::*tie = &Weighted_dual_graph::capacity)
{
  using Index = Weighted_dual_graph::Index;
  // twice the mean; larger nodes would hide narrow protrusions
  const double largest_area = 2. / number_of_nodes;
  // a round that merges less than this share of the nodes is the last
  constexpr double least_progress = 0.02;
  const bool is_parallel = execution.is_parallel();
  Coarse_graph result;
  result.node.resize(graph.number_of_nodes());
  std::iota(result.node.begin(), result.node.end(), Index(0));
  const Weighted_dual_graph* current = &graph; // never a copy: it would be the largest array of a segmentation
  while (current->number_of_nodes() > number_of_nodes)
  {
    execution.check();
    const Index before = current->number_of_nodes();
    const auto match =
      Neighbor_matcher(*current, current->*tie, largest_area)(before - number_of_nodes, is_parallel);
    if (before - match.second < least_progress * before && before < 2 * number_of_nodes)
      break;
    if (match.second == before)
      break;
    result.graph = Graph_contraction(*current, match.first, match.second, is_parallel)();
    current = &result.graph;
    for_each_block(result.node.size(), is_parallel,
                   [&](std::size_t begin, std::size_t end, std::size_t)
                   {
                     for (std::size_t i = begin; i < end; ++i)
                       result.node[i] = match.first[result.node[i]];
                   });
  }
  if (current == &graph)
    result.graph = graph;
  else
    result.graph.length = lengths_between_centres(result.graph, is_parallel);
  return result;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COARSEN_GRAPH_H
