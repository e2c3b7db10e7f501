// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEARCH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEARCH_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_ingredients.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/level_set_cuts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/minimum_cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/value_of_cut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Searches a part of a coarse graph for the cuts that best separate a protrusion from a body: level sets of
// the distances from protrusion tips, improved by minimum cuts.
class Cut_search
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = Graph_partition::Nodes;

  explicit Cut_search(Graph_partition& partition, const Cut_ingredients& ingredients = {})
    : m_partition(partition),
      m_ingredients(ingredients),
      m_sweep(partition),
      m_to_nearest_tip(partition.graph().number_of_nodes()),
      m_rank(partition.graph().number_of_nodes()),
      m_kept(partition.graph().number_of_nodes()),
      m_number(partition.graph().number_of_nodes(), Indexed_surface::no_face())
  {}

  // The cuts of the part with the given nodes along level sets of the given fields, best first. A field is
  // an order of the nodes of the part.
  std::vector<Cut> cuts(Index part_label, const Nodes& part, const std::vector<Nodes>& fields)
  {
    return cuts(part_label, part, fields, [](const Nodes&) { return true; });
  }

  // The same along those level sets for which `accept(nodes)` holds.
  template <typename Accept>
  std::vector<Cut> cuts(Index part_label,
                        const Nodes& part,
                        const std::vector<Nodes>& fields,
                        Accept accept)
  {
    const double part_area = m_partition.area(part);
    std::vector<Level_set> level_sets;
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
      m_sweep(fields[i], part_area, i, false, level_sets);
      m_sweep(Nodes(fields[i].rbegin(), fields[i].rend()), part_area, i, true, level_sets);
    }
    std::stable_sort(level_sets.begin(), level_sets.end(), [](const Level_set& a, const Level_set& b)
                     { return a.relative_cost < b.relative_cost; });
    std::vector<Cut> cuts;
    for (const Nodes& inner : different_sets(part_label, part, fields, level_sets, accept))
    {
      Cut cut = refined(part_label, part, inner, part_area);
      if (std::isfinite(cut.value))
        cuts.push_back(std::move(cut));
    }
    std::stable_sort(cuts.begin(), cuts.end(),
                     [](const Cut& a, const Cut& b) { return a.value > b.value; });
    return cuts;
  }

  // The nodes of a part in the order of their distances from a tip.
  Nodes field_of_tip(Index part_label, Index tip)
  {
    ++m_number_of_runs;
    return m_partition.nodes_by_distance(
      Nodes(1, tip), [&](Index i) { return m_partition.label(i) == part_label; },
      m_partition.graph().seam_lengths());
  }

  // The fields of a part: the distances from each of its tips, which are selected by eq. (2) from the node
  // farthest from the part's centre of gravity on until the part is covered.
  std::vector<Nodes> tip_fields(Index part_label, const Nodes& part)
  {
    constexpr std::size_t maximum_number_of_tips = 12;
    // a tip nearer to another one than that share of the part's size is no tip of its own
    constexpr double least_distance = 0.1;
    const double part_area = m_partition.area(part);
    for (Index i : part)
      m_to_nearest_tip[i] = (std::numeric_limits<double>::infinity)();
    std::vector<Nodes> fields;
    Index tip = field_of_tip(part_label, central_node(part, part_area)).back();
    while (fields.size() < maximum_number_of_tips)
    {
      fields.push_back(field_of_tip(part_label, tip));
      for (Index i : part)
        m_to_nearest_tip[i] = (std::min)(m_to_nearest_tip[i], m_partition.distance(i));
      tip = *std::max_element(part.begin(), part.end(), [&](Index a, Index b)
                              { return m_to_nearest_tip[a] < m_to_nearest_tip[b]; });
      if (m_to_nearest_tip[tip] < least_distance * std::sqrt(part_area))
        break;
    }
    return fields;
  }

  std::size_t number_of_runs() const { return m_number_of_runs; }

private:
  // Level sets of a part that are looked at more closely; a bit each in `m_kept`.
  static constexpr std::size_t maximum_number_of_sets = 10;

  Index central_node(const Nodes& part, double part_area) const
  {
    const Weighted_dual_graph& graph = m_partition.graph();
    const Indexed_surface::Point_3 origin(0, 0, 0);
    Indexed_surface::Vector_3 moment(0, 0, 0);
    for (Index i : part)
      moment += graph.area[i] * (graph.centre_of(i) - origin);
    const Indexed_surface::Point_3 centre = part_area > 0 ? origin + moment / part_area : origin;
    return *std::min_element(part.begin(), part.end(),
                             [&](Index a, Index b)
                             {
                               return squared_distance(graph.centre_of(a), centre) <
                                      squared_distance(graph.centre_of(b), centre);
                             });
  }

  // The best level sets that differ from each other.
  template <typename Accept>
  std::vector<Nodes> different_sets(Index part_label,
                                    const Nodes& part,
                                    const std::vector<Nodes>& fields,
                                    const std::vector<Level_set>& level_sets,
                                    Accept accept)
  {
    constexpr std::size_t looked_at = 60; // most of the rest repeat the first ones
    std::vector<Nodes> kept;
    std::vector<double> kept_areas;
    const double part_area = m_partition.area(part);
    for (Index i : part)
      m_kept[i] = 0;
    std::size_t looked = 0;
    for (const Level_set& level_set : level_sets)
    {
      if (looked == looked_at || kept.size() == maximum_number_of_sets)
        break;
      Nodes nodes = nodes_of(part_label, fields[level_set.field], level_set);
      if (!accept(nodes))
        continue;
      ++looked;
      const double area = m_partition.area(nodes);
      if (is_repetition(nodes, area, part_area, kept_areas))
        continue;
      for (Index node : nodes)
        m_kept[node] |= 1u << kept.size();
      kept.push_back(std::move(nodes));
      kept_areas.push_back(area);
    }
    return kept;
  }

  Nodes nodes_of(Index part_label, const Nodes& field, const Level_set& level_set)
  {
    for (std::size_t i = 0; i < field.size(); ++i)
      m_rank[field[i]] = static_cast<Index>(level_set.descending ? field.size() - 1 - i : i);
    const Index last = m_rank[level_set.node];
    return m_partition.connected_nodes(level_set.node, [&](Index i)
                                       { return m_partition.label(i) == part_label && m_rank[i] <= last; });
  }

  // Whether the set, or its complement, overlaps too much with one of those kept: intersection over union.
  bool is_repetition(const Nodes& nodes,
                     double area,
                     double part_area,
                     const std::vector<double>& kept_areas) const
  {
    constexpr double largest_overlap = 0.8;
    std::array<double, maximum_number_of_sets> common{};
    for (Index node : nodes)
      for (std::size_t k = 0; k < kept_areas.size(); ++k)
        if (m_kept[node] & (1u << k))
          common[k] += m_partition.graph().area[node];
    for (std::size_t k = 0; k < kept_areas.size(); ++k)
    {
      const double both = area + kept_areas[k] - common[k];
      const double with_complement = part_area - kept_areas[k] + common[k];
      if (common[k] > largest_overlap * both || area - common[k] > largest_overlap * with_complement)
        return true;
    }
    return false;
  }

  // A set or, if that costs less for what it cuts off, the minimum cut around it; and its value. A minimum cut
  // is the shorter the less it cuts off, so it need not be better.
  Cut refined(Index part_label, const Nodes& part, const Nodes& set, double part_area)
  {
    constexpr Band band = {0.35, 2, 0.7};
    m_partition.mark(part, set);
    Nodes inner = set;
    if (m_partition.area(set) > part_area / 2)
    {
      inner.clear();
      for (Index i : part)
        if (!m_partition.is_inner(i))
          inner.push_back(i);
    }
    inner = m_partition.connect_sides(part, part_label, inner);
    if (m_ingredients.minimum_cuts)
    {
      const double cost = relative_cost_of(part_label, inner, part_area);
      Nodes minimum = refine_cut(m_partition, part_label, part, inner, band, m_number);
      minimum = m_partition.connect_sides(part, part_label, minimum);
      if (!m_ingredients.choice_of_cheaper || relative_cost_of(part_label, minimum, part_area) < cost)
        inner = std::move(minimum);
      else
        m_partition.mark(part, inner);
    }
    const double value = value_of_cut(m_partition, part_label, inner, part_area, m_ingredients);
    return {std::move(inner), value};
  }

  // `inner` is marked.
  double relative_cost_of(Index part_label, const Nodes& inner, double part_area) const
  {
    const Weighted_dual_graph& graph = m_partition.graph();
    double cost = 0;
    for (Index i : inner)
      for (Index arc : graph.arcs(i))
        if (m_partition.label(graph.target[arc]) == part_label && !m_partition.is_inner(graph.target[arc]))
          cost += graph.capacity[arc];
    return relative_cost(cost, m_partition.area(inner), part_area);
  }

  Graph_partition& m_partition;
  Cut_ingredients m_ingredients;
  Level_set_sweep m_sweep;
  std::vector<double> m_to_nearest_tip;
  std::vector<Index> m_rank;
  std::vector<std::uint32_t> m_kept; // which of the kept sets hold a node, a bit each
  std::vector<Index> m_number;
  std::size_t m_number_of_runs = 0;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEARCH_H
