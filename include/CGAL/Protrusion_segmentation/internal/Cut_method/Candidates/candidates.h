// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_CANDIDATES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_CANDIDATES_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Candidates/level_sets.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Candidates/regions.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Nodes of a segment with a border around them that is worth a closer look.
struct Candidate
{
  Nodes nodes; // ascending, unless a level set
  bool is_region; // else a level set
};

// An order of the nodes of a segment and the best of its level sets.
struct Ordered_level_sets
{
  Nodes order;
  std::vector<Level_set> level_sets;
};

// Chooses the cheapest level sets and regions of a segment that differ from each other.
class Candidate_chooser
{
public:
  using Index = Dual_graph::Index;

  // The arguments must outlive the object.
  Candidate_chooser(const Seam_graph& graph, const Cut_options& options)
    : m_graph(graph), m_options(options), m_rank(graph.number_of_nodes()), m_kept(graph.number_of_nodes())
  {
    CGAL_assertion(options.level_sets + options.regions <= maximum_number_of_candidates);
  }

  // Of the selected segment of a partition, those for which `accept(nodes)` holds.
  template <typename Accept>
  std::vector<Candidate> operator()(Graph_partition& partition,
                                    const Segment& segment,
                                    const std::vector<Ordered_level_sets>& orders,
                                    const Merged_regions& merged,
                                    Accept accept)
  {
    constexpr std::size_t level_sets_looked_at = 60; // most of the rest repeat the first ones
    constexpr std::size_t regions_looked_at = 40;
    for (Index i : segment.nodes)
      m_kept[i] = 0;
    m_kept_areas.clear();
    const std::vector<Numbered_set> sets = cheapest_first(orders);
    std::vector<Candidate> result;
    keep_different(
      sets.size(), [&](std::size_t i) { return nodes_of(partition, orders[sets[i].order].order, sets[i].set.node); },
      [&](const Nodes& nodes)
      {
        return accept(nodes) && (m_kept_areas.size() < m_options.crossing_level_sets || crosses_none_kept(nodes, segment.area));
      },
      segment.area, {level_sets_looked_at, m_options.level_sets}, false, result);
    keep_different(
      merged.regions.size(), [&](std::size_t i) { return nodes_of(merged, merged.regions[i]); }, accept, segment.area,
      {regions_looked_at, m_options.regions}, true, result);
    return result;
  }

private:
  static constexpr std::size_t maximum_number_of_candidates = 32; // a bit each in `m_kept`

  struct Numbered_set
  {
    Level_set set;
    std::size_t order;
  };

  static std::vector<Numbered_set> cheapest_first(const std::vector<Ordered_level_sets>& orders)
  {
    std::vector<Numbered_set> result;
    for (std::size_t order = 0; order < orders.size(); ++order)
      for (const Level_set& set : orders[order].level_sets)
        result.push_back({set, order});
    std::stable_sort(result.begin(), result.end(), [](const Numbered_set& a, const Numbered_set& b)
                     { return a.set.relative_cost < b.set.relative_cost; });
    return result;
  }

  struct Limits
  {
    std::size_t looked_at, kept;
  };

  // Appends those of a number of sets of nodes, `nodes_of(i)`, that are accepted and repeat none of those kept.
  template <typename NodesOf, typename Accept>
  void keep_different(std::size_t number,
                      NodesOf nodes_of,
                      Accept accept,
                      double segment_area,
                      Limits left,
                      bool are_regions,
                      std::vector<Candidate>& result)
  {
    for (std::size_t i = 0; i < number && left.looked_at > 0 && left.kept > 0; ++i)
    {
      Nodes nodes = nodes_of(i);
      if (!accept(nodes))
        continue;
      --left.looked_at;
      const double area = m_graph.area_of(nodes);
      if (is_repetition(nodes, area, segment_area))
        continue;
      --left.kept;
      for (Index node : nodes)
        m_kept[node] |= 1u << m_kept_areas.size();
      m_kept_areas.push_back(area);
      result.push_back({std::move(nodes), are_regions});
    }
  }

  static Nodes nodes_of(const Merged_regions& merged, const Region& region)
  {
    const auto first = merged.order.begin() + region.first;
    Nodes nodes(first, first + region.number_of_nodes);
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  // of a level set
  Nodes nodes_of(Graph_partition& partition, const Nodes& order, Index last_node)
  {
    for (std::size_t i = 0; i < order.size(); ++i)
      m_rank[order[i]] = static_cast<Index>(i);
    const Index last = m_rank[last_node];
    return partition.connected_nodes(last_node, [&](Index i) { return partition.is_selected(i) && m_rank[i] <= last; });
  }

  // Whether the set, or its complement, overlaps too much with one of those kept: intersection over union.
  bool is_repetition(const Nodes& nodes, double area, double segment_area) const
  {
    const std::uint32_t similar = sets_of_similar_area(area, segment_area);
    if (similar == 0)
      return false;
    const Areas common = common_areas(nodes, similar);
    for (std::size_t k = 0; k < m_kept_areas.size(); ++k)
    {
      const double both = area + m_kept_areas[k] - common[k];
      const double with_complement = segment_area - m_kept_areas[k] + common[k];
      if (similar >> k & 1 && (common[k] > largest_overlap * both || area - common[k] > largest_overlap * with_complement))
        return true;
    }
    return false;
  }

  // Whether the set is no bump of a ragged edge and crosses none of those kept: two sets cross where their borders divide the segment
  // in four parts, each large enough to be a segment.
  bool crosses_none_kept(const Nodes& nodes, double segment_area) const
  {
    constexpr double least_area = 2 * least_area_of_segment; // smaller ones cut washers, larger ones miss arms of stars
    const double area = m_graph.area_of(nodes);
    if ((std::min)(area, segment_area - area) < least_area)
      return false;
    const Areas common = common_areas(nodes, ~0u);
    for (std::size_t k = 0; k < m_kept_areas.size(); ++k)
    {
      const double both = area + m_kept_areas[k] - common[k];
      if ((std::min)({common[k], area - common[k], m_kept_areas[k] - common[k], segment_area - both}) >= least_area_of_segment)
        return false;
    }
    return true;
  }

  using Areas = std::array<double, maximum_number_of_candidates>;

  // The areas that a set has in common with those of the sets kept whose bits are given.
  Areas common_areas(const Nodes& nodes, std::uint32_t of_kept) const
  {
    Areas common{};
    for (Index node : nodes)
      for (std::uint32_t bits = m_kept[node] & of_kept, k = 0; bits != 0; bits >>= 1, ++k)
        if (bits & 1)
          common[k] += m_graph.area[node];
    return common;
  }

  // Of the sets kept, a bit each, those that can overlap that much, by their areas.
  std::uint32_t sets_of_similar_area(double area, double segment_area) const
  {
    std::uint32_t result = 0;
    for (std::size_t k = 0; k < m_kept_areas.size(); ++k)
      for (double kept : {m_kept_areas[k], segment_area - m_kept_areas[k]})
        if ((std::min)(area, kept) > largest_overlap * (std::max)(area, kept))
          result |= 1u << k;
    return result;
  }

  static constexpr double largest_overlap = 0.8;

  const Seam_graph& m_graph;
  const Cut_options& m_options;
  std::vector<Index> m_rank;
  std::vector<std::uint32_t> m_kept; // which of the sets kept hold a node, a bit each
  std::vector<double> m_kept_areas;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_CANDIDATES_H
