// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_SURE_CUTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_SURE_CUTS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_memo.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Makes several cuts of a segment at once: those that are sure or whose parts are like others, and whose inner sides have
// nothing in common. One at a time, the arms of a star would each be worth less than a cut through its core, which parts half
// of the star from the other half.
class Sure_cuts
{
public:
  using Index = Dual_graph::Index;

  // The arguments must outlive the object.
  Sure_cuts(const Volume_graph& graph, Segment_memo& memo, const Cut_options& options)
    : m_graph(graph), m_memo(memo), m_options(options), m_partition(graph)
  {
    constexpr double largest_opening = 0.01; // relative to the area; sheets and shells have larger ones
    Nodes all(graph.number_of_nodes());
    std::iota(all.begin(), all.end(), Index(0));
    m_is_closed = flatness(all) < largest_opening;
  }

  // For a set and one of its segments, whose cuts are known: the set with the two of these that are worth most, with three, and so on.
  std::vector<Cut_set> operator()(const Cut_set& set, Index segment)
  {
    std::vector<Cut_set> result = {set};
    Index rest = segment;
    for (const Cut* cut : best_first(compatible_cuts(segment)))
      if (can_be_cut_off(m_memo[rest].segment, cut->inner))
      {
        result.push_back(with_cut(result.back(), rest, *cut));
        rest = result.back().cuts.back().outer;
      }
    result.erase(result.begin(), result.begin() + (std::min)(result.size(), std::size_t(2)));
    return result;
  }

private:
  using Cuts = std::vector<const Cut*>;

  // The surest one, the surest one that can be made besides, and so on. What lies along earlier borders may be a scrap of these.
  Cuts compatible_cuts(Index segment)
  {
    constexpr double most_neighbors = 0.4; // earlier borders half as long as the cut
    Cuts sure;
    for (const Cut& cut : m_memo[segment].cuts)
      if ((m_options.is_sure(cut.log_odds) || cut.like_part > 0) && cut.clues.neighbors <= most_neighbors)
        sure.push_back(&cut);
    std::stable_sort(sure.begin(), sure.end(), [](const Cut* a, const Cut* b) { return a->log_odds > b->log_odds; });
    Cuts result;
    Segment rest = m_memo[segment].segment;
    for (const Cut* cut : sure)
      if (can_be_cut_off(rest, cut->inner))
      {
        result.push_back(cut);
        rest.nodes = other_side(rest, cut->inner);
        rest.area -= m_graph.area_of(cut->inner);
      }
    return result;
  }

  static Cuts best_first(Cuts cuts)
  {
    std::stable_sort(cuts.begin(), cuts.end(), [](const Cut* a, const Cut* b) { return a->value > b->value; });
    return cuts;
  }

  // Whether a side lies in a segment, and what is left of that is connected, large enough, and no flat side of a closed surface: an
  // underside belongs to what stands on it.
  bool can_be_cut_off(const Segment& segment, const Nodes& side)
  {
    if (!std::includes(segment.nodes.begin(), segment.nodes.end(), side.begin(), side.end()) ||
        !is_large_enough(m_graph.area_of(side), segment.area))
      return false;
    const Nodes rest = other_side(segment, side);
    if (m_is_closed && flatness(rest) > m_options.weights.least_flatness)
      return false;
    m_partition.select({rest, 0});
    return m_partition.connected_nodes(rest.front(), [&](Index i) { return m_partition.is_selected(i); }).size() == rest.size();
  }

  // The length of the sum of the area vectors relative to the area.
  double flatness(const Nodes& nodes) const
  {
    Indexed_surface::Vector_3 area_vector(0, 0, 0);
    for (Index i : nodes)
      area_vector += m_graph.area_vector[i];
    return std::sqrt(area_vector.squared_length()) / m_graph.area_of(nodes);
  }

  // The cut was found in a larger segment. It is as sure in what is left of that.
  Cut_set with_cut(const Cut_set& set, Index segment, Cut cut)
  {
    const double area = m_graph.area_of(cut.inner);
    cut.root_of_areas = std::sqrt(area * (m_memo[segment].segment.area - area));
    return set.with(m_memo.made_cut(segment, cut, set.gain(cut, m_options.weights)));
  }

  const Volume_graph& m_graph;
  Segment_memo& m_memo;
  const Cut_options& m_options;
  Graph_partition m_partition;
  bool m_is_closed; // the area vectors of a closed surface cancel out
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_SURE_CUTS_H
