// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_CUTS_OF_TIPS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_CUTS_OF_TIPS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_memo.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_search.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Cuts off one protrusion for each picked tip.
class Tip_cuts
{
public:
  using Index = Dual_graph::Index;

  // The arguments must outlive the object.
  Tip_cuts(const Graphs_of_surface& graphs, Segment_search& search, Segment_memo& memo, Execution& execution)
    : m_graphs(graphs), m_search(search), m_memo(memo), m_execution(execution)
  {}

  // For the tips, in their order: cuts off the protrusion with the best border that has the tip, but none of the others, and
  // at most half of the surface. `whole`: the set without cuts; `kept`: cuts that the first tips have already
  Cut_set operator()(const Cut_set& whole, const Cut_set& kept, const std::vector<Index>& faces)
  {
    const std::vector<Index> tips = nodes_of_tips(whole.segments.front(), faces);
    Cut_set result = kept;
    for (std::size_t t = kept.cuts.size(); t < faces.size(); ++t)
    {
      m_execution.check();
      const Index segment = m_memo.segment_with(tips[t], result);
      if (const std::optional<Cut> cut = cut_of_tip(m_memo[segment].segment, tips[t], tips))
        result = result.with(m_memo.made_cut(segment, *cut, cut->value));
    }
    return result;
  }

private:
  // The nodes of the picked tips, and where these are few of further ones that are about as far from each other.
  std::vector<Index> nodes_of_tips(Index whole, const std::vector<Index>& faces)
  {
    constexpr double least_share_of_distance = 0.35; // nearer ones are not ends of other protrusions
    double largest_distance = 0;
    std::vector<double> to_nearest_tip(m_graphs.coarse.number_of_nodes(), (std::numeric_limits<double>::max)());
    std::vector<Index> tips;
    while (!faces.empty() && tips.size() < (std::max)(faces.size(), least_number_of_tips))
    {
      const auto farthest = std::max_element(to_nearest_tip.begin(), to_nearest_tip.end());
      if (!tips.empty())
        largest_distance = (std::max)(largest_distance, *farthest);
      if (tips.size() >= faces.size() && *farthest < least_share_of_distance * largest_distance)
        break;
      tips.push_back(tips.size() < faces.size() ? m_graphs.node_of_face[faces[tips.size()]]
                                                : static_cast<Index>(farthest - to_nearest_tip.begin()));
      const Nodes_by_distance from_tip = m_search.from_tip(m_memo[whole].segment, tips.back());
      for (std::size_t i = 0; i < from_tip.nodes.size(); ++i)
        to_nearest_tip[from_tip.nodes[i]] = (std::min)(to_nearest_tip[from_tip.nodes[i]], from_tip.distances[i]);
    }
    return tips;
  }

  std::optional<Cut> cut_of_tip(const Segment& segment, Index tip, const std::vector<Index>& tips)
  {
    std::vector<bool> is_other_tip(m_graphs.coarse.number_of_nodes(), false);
    for (Index other : tips)
      is_other_tip[other] = other != tip; // two tips in one node are one
    // of a segment; what is more is the body without something else
    const double largest_share = has_any(segment.nodes, is_other_tip) ? 0.5 : 0.75;
    return m_search.cut_of_tip(segment, tip,
                               [&](const Nodes& nodes)
                               {
                                 const double area = m_graphs.coarse.area_of(nodes);
                                 return 2 * area <= 1 && area <= largest_share * segment.area &&
                                        std::find(nodes.begin(), nodes.end(), tip) != nodes.end() &&
                                        !has_any(nodes, is_other_tip);
                               });
  }

  static bool has_any(const Nodes& nodes, const std::vector<bool>& is_tip)
  {
    return std::any_of(nodes.begin(), nodes.end(), [&](Index i) { return is_tip[i]; });
  }

  const Graphs_of_surface& m_graphs;
  Segment_search& m_search;
  Segment_memo& m_memo;
  Execution& m_execution;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_CUTS_OF_TIPS_H
