// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_COARSEN_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_COARSEN_GRAPH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/contract_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Float_key.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <CGAL/number_utils.h>

#include <boost/range/irange.hpp>
#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A graph as neighbours are matched on it: the arcs of node i are first_arc[i] to first_arc[i + 1] - 1.
struct Affinities
{
  using Index = Indexed_surface::Index;

  const std::vector<Index>& first_arc;
  const std::vector<Index>& target;   // of every arc
  const std::vector<float>& affinity; // of every arc, the same as that of the arc back
  const std::vector<double>& area;    // of every node

  Index number_of_nodes() const { return static_cast<Index>(area.size()); }
  boost::integer_range<Index> arcs(Index node) const { return boost::irange(first_arc[node], first_arc[node + 1]); }
};

// The same with arrays of its own.
struct Affinity_graph
{
  std::vector<Affinities::Index> first_arc = std::vector<Affinities::Index>(1, 0);
  std::vector<Affinities::Index> target;
  std::vector<float> affinity;
  std::vector<double> area;

  Affinities view() const { return {first_arc, target, affinity, area}; }
};

// Pairs every node with the neighbour of largest affinity for its size, small nodes first, if the pair is no larger than
// `largest_area`.
//
// Matching is greedy and depends on the order. To be the same with any number of threads it stays within blocks of
// consecutive nodes, which lie near each other on the surface. Where they do not, since the surface is as narrow as a face, one
// block has all nodes.
class Neighbor_matcher
{
public:
  using Index = Affinities::Index;

  Neighbor_matcher(const Affinities& nodes, double largest_area)
    : m_nodes(nodes), m_largest_area(largest_area), m_partner(nodes.number_of_nodes(), unmatched)
  {}

  // The pairs, no more than `wanted`.
  Clusters operator()(Index wanted, bool is_parallel)
  {
    // of sixteen thousand nodes the arrays fit into a core's cache, and few have their best partner in another block
    constexpr std::size_t nodes_of_block = 1 << 14;
    const Index n = m_nodes.number_of_nodes();
    Clusters result = pairs_in_blocks(nodes_of_block, wanted, is_parallel);
    if (n > nodes_of_block && n - result.number < (std::min)(wanted, n / 2) / 2)
    {
      std::fill(m_partner.begin(), m_partner.end(), unmatched);
      result = pairs_in_blocks(n, wanted, false);
    }
    return result;
  }

private:
  static constexpr Index unmatched = Indexed_surface::no_face();

  struct Block
  {
    Index begin, end;
  };

  Clusters pairs_in_blocks(std::size_t nodes_of_block, Index wanted, bool is_parallel)
  {
    const std::size_t n = m_partner.size();
    const std::size_t number_of_blocks = (n + nodes_of_block - 1) / nodes_of_block;
    const auto block = [&](std::size_t b)
    {
      return Block{static_cast<Index>(b * nodes_of_block), static_cast<Index>((std::min)(n, (b + 1) * nodes_of_block))};
    };
    const auto share = [&](Index nodes) { return static_cast<Index>(std::uint64_t(wanted) * nodes / n); };
    std::vector<Index> first_number(number_of_blocks + 1, 0); // of the pairs of each block
    for_each_index(number_of_blocks, is_parallel,
                   [&](std::size_t b)
                   {
                     const auto [begin, end] = block(b);
                     first_number[b + 1] = end - begin - match_nodes({begin, end}, share(end) - share(begin));
                   });
    std::partial_sum(first_number.begin(), first_number.end(), first_number.begin());
    std::vector<Index> number(n);
    for_each_index(number_of_blocks, is_parallel,
                   [&](std::size_t b)
                   {
                     Index next = first_number[b];
                     for (Index i = block(b).begin; i < block(b).end; ++i)
                       number[i] = m_partner[i] < i ? number[m_partner[i]] : next++;
                   });
    return {std::move(number), first_number.back()};
  }

  // Returns how many pairs it made, at most `wanted`.
  Index match_nodes(const Block& block, Index wanted)
  {
    std::vector<Float_key> keys; // by area, as far as single precision tells them apart
    keys.reserve(block.end - block.begin);
    for (Index i = block.begin; i < block.end; ++i)
      keys.push_back(float_key(static_cast<float>(m_nodes.area[i]), i));
    boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
    Index pairs = 0;
    for (std::size_t k = 0; k < keys.size() && pairs < wanted; ++k)
      if (m_partner[index_of(keys[k])] == unmatched)
        pairs += match(index_of(keys[k]), block);
    return pairs;
  }

  // Returns whether it found a partner.
  bool match(Index i, const Block& block)
  {
    double strongest = -1;
    for (Index arc : m_nodes.arcs(i))
    {
      const Index j = m_nodes.target[arc];
      if (j == i || j < block.begin || j >= block.end || m_partner[j] != unmatched ||
          m_nodes.area[i] + m_nodes.area[j] > m_largest_area)
        continue;
      const double area = m_nodes.area[i] * m_nodes.area[j];
      const double strength =
        area > 0 ? CGAL::square(static_cast<double>(m_nodes.affinity[arc])) / area : (std::numeric_limits<double>::max)();
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

  Affinities m_nodes;
  double m_largest_area;
  std::vector<Index> m_partner;
};

// Contracts affinities: those between the nodes of two sets add up.
inline Affinity_graph contract_affinities(const Affinities& nodes, const Clusters& clusters, bool is_parallel)
{
  using Index = Affinities::Index;
  const Index_groups sets(clusters.of_node, clusters.number);
  Affinity_graph result;
  result.area.resize(clusters.number);
  for_each_number(clusters.number, is_parallel,
                  [&](Index u)
                  {
                    for (Index i : sets[u])
                      result.area[u] += nodes.area[i];
                  });
  result.affinity.reserve(nodes.affinity.size());
  Arc_merger<float>(nodes.first_arc, nodes.target, clusters.of_node, sets)(
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
    const Clusters pairs = Neighbor_matcher(current, largest_area)(result.number - number, execution.is_parallel());
    if (pairs.number == result.number ||
        (result.number - pairs.number < least_progress * result.number && result.number < 2 * number))
      break;
    if (pairs.number > number)
      sets = contract_affinities(current, pairs, execution.is_parallel());
    for_each_number(result.of_node.size(), execution.is_parallel(),
                    [&](Index i) { result.of_node[i] = pairs.of_node[result.of_node[i]]; });
    result.number = pairs.number;
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
