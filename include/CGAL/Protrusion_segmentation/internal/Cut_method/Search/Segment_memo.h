// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_SEGMENT_MEMO_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_SEGMENT_MEMO_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/like_parts.h>

#include <algorithm>
#include <deque>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A segmentation of a connected surface by cuts, each of which splits a segment in two. Segments are those of a memo.
struct Cut_set
{
  using Index = Dual_graph::Index;

  struct Made_cut
  {
    Index segment, inner, outer;
    double value;
    double log_odds = 0; // by its clues alone
    bool is_distinct = true;
    Size_of_part size = {};
  };

  std::vector<Index> segments; // that are left, ascending
  std::vector<Made_cut> cuts;  // in the order in which they were made
  double value = 0;            // sum of those of the cuts

  // The segments in the order of the cuts that made them, the inner side of a cut first. That order comes from the
  // shape alone, not from how its faces and nodes are numbered.
  std::vector<Index> in_order_of_cuts() const
  {
    if (cuts.empty())
      return segments;
    std::vector<Index> result;
    for (const Made_cut& cut : cuts)
      for (Index side : {cut.inner, cut.outer})
        if (std::binary_search(segments.begin(), segments.end(), side))
          result.push_back(side);
    return result;
  }

  // What a cut would add to the value: its own, with larger odds if there is a part like that one, cut off before or not.
  double gain(const Cut& cut, const Cut_weights& weights) const
  {
    double evidence = cut.like_part;
    for (const Made_cut& made : cuts)
      evidence = (std::max)(evidence, evidence_of_part(weights, cut, made.size, made.log_odds));
    return value_of_cut(cut.log_odds + evidence, cut.root_of_areas);
  }

  Cut_set with(const Made_cut& cut) const
  {
    Cut_set result = *this;
    result.segments.erase(std::find(result.segments.begin(), result.segments.end(), cut.segment));
    for (Index side : {cut.inner, cut.outer})
      result.segments.insert(std::upper_bound(result.segments.begin(), result.segments.end(), side), side);
    result.cuts.push_back(cut);
    result.value += cut.value;
    return result;
  }
};

// All sets of nodes that were segments in any of the segmentations looked at, each with its cuts. A set that comes up again is
// the same segment and is not searched again.
class Segment_memo
{
public:
  using Index = Dual_graph::Index;

  struct Entry
  {
    Segment segment;
    std::vector<Cut> cuts; // best first
    bool is_searched = false;
  };

  // The graph must outlive the object.
  explicit Segment_memo(const Dual_graph& graph) : m_graph(graph) {}

  Index number_of_segments() const { return static_cast<Index>(m_entries.size()); }
  const Entry& operator[](Index id) const { return m_entries[id]; }

  // The segment with the given nodes, in ascending order.
  Index find_or_add(Nodes nodes)
  {
    const auto [found, is_new] = m_ids.emplace(std::move(nodes), number_of_segments());
    if (is_new)
      m_entries.push_back({{found->first, m_graph.area_of(found->first)}, {}});
    return found->second;
  }

  // Gives a segment its cuts, best first.
  void set_cuts(Index id, std::vector<Cut> cuts)
  {
    m_entries[id].cuts = std::move(cuts);
    m_entries[id].is_searched = true;
  }

  // That of the set's segments that has a node.
  Index segment_with(Index node, const Cut_set& set) const
  {
    return *std::find_if(set.segments.begin(), set.segments.end(),
                         [&](Index id)
                         {
                           const Nodes& nodes = m_entries[id].segment.nodes;
                           return std::binary_search(nodes.begin(), nodes.end(), node);
                         });
  }

  // `value`: what the cut adds to that of the set in which it is made
  Cut_set::Made_cut made_cut(Index id, const Cut& cut, double value)
  {
    return made_cut(id, cut.inner, {0, 0, 0, value, cut.log_odds, is_distinct(cut.clues), cut.size});
  }

  // The same cut of another segment.
  Cut_set::Made_cut made_cut(Index id, const Nodes& inner, Cut_set::Made_cut cut)
  {
    cut.segment = id;
    cut.inner = find_or_add(inner);
    cut.outer = find_or_add(other_side(m_entries[id].segment, inner));
    return cut;
  }

private:
  const Dual_graph& m_graph;
  std::deque<Entry> m_entries; // at fixed addresses, while others are added
  std::map<Nodes, Index> m_ids;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_SEGMENT_MEMO_H
