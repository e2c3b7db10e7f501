// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEARCH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEARCH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/level_set_cuts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/merged_regions.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/minimum_cut.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Searches a segment of a coarse graph for the cuts that best separate a protrusion from a body: around level sets of
// the distances from protrusion tips and around regions that hang together, improved by minimum cuts.
class Cut_search
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = Graph_partition::Nodes;

  Cut_search(Graph_partition& partition, const Cut_policy& policy, Execution& execution)
    : m_partition(partition),
      m_policy(policy),
      m_execution(execution),
      m_sweep(partition),
      m_rank(partition.graph().number_of_nodes()),
      m_kept(partition.graph().number_of_nodes()),
      m_number(partition.graph().number_of_nodes(), Indexed_surface::no_face())
  {}

  // Nodes of a segment with a border worth looking for around them.
  struct Candidate
  {
    Nodes nodes;
    bool is_region; // else a level set
  };

  // An order of the nodes of a segment and its best level sets, from the near and from the far end.
  struct Sweeps
  {
    std::size_t number;
    Nodes order;
    std::vector<Level_set> upwards, downwards;
  };

  // What candidates are taken from: level sets and regions.
  struct Candidate_sources
  {
    std::deque<Sweeps> sweeps; // which stay where they are while further ones are added
    Merged_regions regions;

    Sweeps& add_order(Nodes order)
    {
      sweeps.push_back({sweeps.size(), std::move(order), {}, {}});
      return sweeps.back();
    }
  };

  struct Accept_all
  {
    bool operator()(const Nodes&) const { return true; }
  };

  // The cuts of a segment with the given nodes around those level sets of the orders in `sources` and those regions for which
  // `accept(nodes)` holds, best first.
  template <typename Accept = Accept_all>
  std::vector<Cut> cuts(Index segment, const Nodes& nodes, Candidate_sources sources, Accept accept = Accept())
  {
    for (Sweeps& sweeps : sources.sweeps)
      for (bool descending : {false, true})
        find_level_sets(nodes, descending, sweeps);
    sources.regions = regions(segment, nodes);
    std::vector<std::optional<Cut>> result;
    candidates(segment, nodes, sources, accept, [&](const Candidate& candidate)
               { result.push_back(cut_around(segment, nodes, candidate)); });
    std::vector<Cut> cuts = different(std::move(result));
    sort_best_first(cuts);
    return cuts;
  }

  Merged_regions regions(Index segment, const Nodes& nodes)
  {
    return m_merger(m_partition, segment, nodes, m_partition.area(nodes), m_rank);
  }

  // The best level sets of one of the two sweeps over an order of the nodes, upwards or downwards.
  void find_level_sets(const Nodes& nodes, bool descending, Sweeps& sweeps)
  {
    const double segment_area = m_partition.area(nodes);
    const Nodes& order = sweeps.order;
    if (descending)
      m_sweep(Nodes(order.rbegin(), order.rend()), segment_area, sweeps.number, true, sweeps.downwards);
    else
      m_sweep(order, segment_area, sweeps.number, false, sweeps.upwards);
  }

  std::size_t most_candidates() const { return maximum_number_of_level_sets + m_policy.number_of_regions(); }

  // Calls `visit(candidate)` with the best level sets and regions that are accepted and differ from each other.
  template <typename Accept, typename Visit>
  void candidates(Index segment, const Nodes& nodes, const Candidate_sources& sources, Accept accept, Visit visit)
  {
    constexpr std::size_t level_sets_looked_at = 60; // most of the rest repeat the first ones
    constexpr std::size_t regions_looked_at = 40;
    const std::size_t number_of_regions = m_policy.number_of_regions();
    CGAL_assertion(most_candidates() <= maximum_number_of_candidates);
    const double segment_area = m_partition.area(nodes);
    const std::vector<Level_set> sets = best_first(sources.sweeps);
    for (Index i : nodes)
      m_kept[i] = 0;
    std::vector<double> kept_areas;
    keep_different(
      sets.size(), [&](std::size_t i) -> Candidate
      { return {nodes_of(segment, sources.sweeps[sets[i].order].order, sets[i]), false}; },
      accept, segment_area, {level_sets_looked_at, maximum_number_of_level_sets}, kept_areas, visit);
    const Merged_regions& merged = sources.regions;
    keep_different(
      merged.regions.size(), [&](std::size_t i) -> Candidate { return {nodes_of(merged, merged.regions[i]), true}; },
      accept, segment_area, {regions_looked_at, number_of_regions}, kept_areas, visit);
  }

  // The cut around a candidate or the minimum cut near it. Around a tip there is always something to be cut off, if it is
  // asked for; a region is a guess, and there is no cut if it is a wrong one.
  std::optional<Cut> cut_around(Index segment, const Nodes& nodes, const Candidate& candidate)
  {
    m_execution.check();
    std::optional<Cut> cut = refined(segment, nodes, candidate.nodes, m_partition.area(nodes));
    if (cut && candidate.is_region && cut->value < 0)
      return std::nullopt;
    return cut;
  }

  // The cut around some nodes as it is, but for what it takes to have connected sides; none if one of these would be too
  // small.
  std::optional<Cut> cut_without_search(Index segment, const Nodes& nodes, const Nodes& side)
  {
    m_execution.check();
    const double segment_area = m_partition.area(nodes);
    m_partition.mark(nodes, side);
    Cut cut;
    cut.inner = m_partition.connect_sides(nodes, segment, smaller_side(nodes, side, segment_area));
    return valued(segment, nodes, segment_area, std::move(cut));
  }

  // Minimum cuts near different candidates may be the same. Then they would keep the beam from what is different.
  static std::vector<Cut> different(std::vector<std::optional<Cut>> cuts)
  {
    std::vector<Cut> result;
    for (std::optional<Cut>& cut : cuts)
      if (cut && std::none_of(result.begin(), result.end(), [&](const Cut& other) { return other.inner == cut->inner; }))
        result.push_back(std::move(*cut));
    return result;
  }

private:
  // Level sets of a segment that are looked at more closely.
  static constexpr std::size_t maximum_number_of_level_sets = 10;
  // What is looked at more closely is a bit each in `m_kept`.
  static constexpr std::size_t maximum_number_of_candidates = 32;

  // the cheapest first
  static std::vector<Level_set> best_first(const std::deque<Sweeps>& all)
  {
    std::vector<Level_set> result;
    for (const Sweeps& sweeps : all)
      for (const std::vector<Level_set>* part : {&sweeps.upwards, &sweeps.downwards})
        result.insert(result.end(), part->begin(), part->end());
    std::stable_sort(result.begin(), result.end(), [](const Level_set& a, const Level_set& b)
                     { return a.relative_cost < b.relative_cost; });
    return result;
  }

  struct Limits
  {
    std::size_t looked_at, kept;
  };

  // Visits those of a number of candidates, `candidate_of(i)`, that are accepted and repeat none of those kept.
  template <typename CandidateOf, typename Accept, typename Visit>
  void keep_different(std::size_t number,
                      CandidateOf candidate_of,
                      Accept accept,
                      double segment_area,
                      Limits left,
                      std::vector<double>& kept_areas,
                      Visit visit)
  {
    for (std::size_t i = 0; i < number && left.looked_at > 0 && left.kept > 0; ++i)
    {
      Candidate candidate = candidate_of(i);
      if (!accept(candidate.nodes))
        continue;
      --left.looked_at;
      const double area = m_partition.area(candidate.nodes);
      if (is_repetition(candidate.nodes, area, segment_area, kept_areas))
        continue;
      --left.kept;
      for (Index node : candidate.nodes)
        m_kept[node] |= 1u << kept_areas.size();
      kept_areas.push_back(area);
      visit(std::move(candidate));
    }
  }

  static Nodes nodes_of(const Merged_regions& merged, const Region& region)
  {
    const auto first = merged.order.begin() + region.first;
    Nodes nodes(first, first + region.number_of_nodes);
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  Nodes nodes_of(Index segment, const Nodes& order, const Level_set& level_set)
  {
    for (std::size_t i = 0; i < order.size(); ++i)
      m_rank[order[i]] = static_cast<Index>(level_set.descending ? order.size() - 1 - i : i);
    const Index last = m_rank[level_set.node];
    return m_partition.connected_nodes(level_set.node, [&](Index i)
                                       { return m_partition.segment(i) == segment && m_rank[i] <= last; });
  }

  // Whether the set, or its complement, overlaps too much with one of those kept: intersection over union.
  bool is_repetition(const Nodes& nodes,
                     double area,
                     double segment_area,
                     const std::vector<double>& kept_areas) const
  {
    constexpr double largest_overlap = 0.8;
    std::array<double, maximum_number_of_candidates> common{};
    for (Index node : nodes)
      for (std::size_t k = 0; k < kept_areas.size(); ++k)
        if (m_kept[node] & (1u << k))
          common[k] += m_partition.graph().area[node];
    for (std::size_t k = 0; k < kept_areas.size(); ++k)
    {
      const double both = area + kept_areas[k] - common[k];
      const double with_complement = segment_area - kept_areas[k] + common[k];
      if (common[k] > largest_overlap * both || area - common[k] > largest_overlap * with_complement)
        return true;
    }
    return false;
  }

  // `inner`, which is marked, or the other side, which is marked then.
  Nodes smaller_side(const Nodes& nodes, Nodes inner, double segment_area)
  {
    if (2 * m_partition.area(inner) <= segment_area)
      return inner;
    for (Index i : nodes)
      m_partition.set_inner(i, !m_partition.is_inner(i));
    return m_partition.marked(nodes);
  }

  // The cut around a set of nodes or the minimum cut near it, both sides connected; none if one of these is too small.
  std::optional<Cut> refined(Index segment, const Nodes& nodes, const Nodes& set, double segment_area)
  {
    constexpr Band band = {0.35, 1.4, 0.7};
    Cut cut;
    cut.inner = m_partition.connect_other_side(nodes, segment, set, 2 * m_partition.area(set) > segment_area);
    const double cost = relative_cost_of(segment, cut.inner, segment_area);
    Nodes minimum = refine_cut(m_partition, segment, nodes, cut.inner, band, m_number);
    minimum = m_partition.connect_sides(nodes, segment, minimum);
    if (m_policy.prefers_minimum_cut(cost, relative_cost_of(segment, minimum, segment_area)))
      cut.inner = std::move(minimum);
    else
      m_partition.mark(nodes, cut.inner);
    return valued(segment, nodes, segment_area, std::move(cut));
  }

  // `cut.inner` is marked; either side may be the smaller one.
  std::optional<Cut> valued(Index segment, const Nodes& nodes, double segment_area, Cut cut)
  {
    cut.inner = smaller_side(nodes, std::move(cut.inner), segment_area);
    value_cut(m_partition, segment, nodes, segment_area, m_policy, cut);
    if (!std::isfinite(cut.value))
      return std::nullopt;
    return cut;
  }

  // `inner` is marked.
  double relative_cost_of(Index segment, const Nodes& inner, double segment_area) const
  {
    double cost = 0;
    m_partition.for_each_arc_of_cut(segment, inner, [&](Index arc, Index, Index)
                                    { cost += m_partition.graph().capacity[arc]; });
    return relative_cost(cost, m_partition.area(inner), segment_area);
  }

  Graph_partition& m_partition;
  const Cut_policy& m_policy;
  Execution& m_execution;
  Level_set_sweep m_sweep;
  Region_merger m_merger;
  std::vector<Index> m_rank;
  std::vector<std::uint32_t> m_kept; // which of the candidates hold a node, a bit each
  std::vector<Index> m_number;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEARCH_H
