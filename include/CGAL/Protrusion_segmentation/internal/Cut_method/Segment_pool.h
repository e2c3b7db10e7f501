// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEGMENT_POOL_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEGMENT_POOL_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// All sets of nodes that were segments in any of the segmentations looked at, each with its cuts. A set that comes up
// again is the same segment, whose cuts are not searched again.
//
// Many a segment is nearly one that has been searched: a body without one of its arms, or without the same arm cut off a
// little higher, or the same two arms in another order. It takes over the cuts of that one, its source, as far as they
// divide it.
class Segment_pool
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = Graph_partition::Nodes;

  struct Segment
  {
    Nodes nodes; // ascending
    double area;
    Index source;               // itself if it is searched on its own
    std::vector<Cut> cuts = {}; // best first
    bool is_searched = false;
    std::optional<std::vector<Cut>> own_cuts = std::nullopt; // that were found in it, also before `begin_again()`
  };

  // The graph must outlive the object. `least_overlap`: the share of the area of both, their intersection over their union,
  // that two segments must have in common for one to be the source of the other.
  Segment_pool(const Weighted_dual_graph& graph, double least_overlap) : m_graph(graph), m_least_overlap(least_overlap) {}

  Index number_of_segments() const { return static_cast<Index>(m_segments.size()); }
  const Segment& operator[](Index id) const { return m_segments[id]; }

  // The segment with the given nodes, in ascending order.
  Index find_or_add(Nodes nodes)
  {
    const auto [found, is_new] = m_ids.emplace(std::move(nodes), number_of_segments());
    if (is_new)
      m_segments.push_back({found->first, m_graph.area_of(found->first), found->second});
    return found->second;
  }

  // Of the segments that have been searched on their own the one that is most like a segment, if it is like it; else the
  // segment itself. The first of equals.
  Index find_source(Index id)
  {
    Index source = id;
    double largest = m_least_overlap;
    for (Index other : m_sources)
      if (const double overlap = overlap_of(id, other, largest); overlap > largest)
      {
        largest = overlap;
        source = other;
      }
    return m_segments[id].source = source;
  }

  // Gives a segment its cuts, in any order: those of its source, as far as they divide it, or its own.
  void take_over(Index id, std::vector<Cut> cuts)
  {
    sort_best_first(cuts);
    m_segments[id].cuts = std::move(cuts);
    m_segments[id].is_searched = true;
  }
  void set_own_cuts(Index id, std::vector<Cut> cuts)
  {
    m_segments[id].source = id;
    m_sources.push_back(id);
    take_over(id, std::move(cuts));
    m_segments[id].own_cuts = m_segments[id].cuts;
  }

  // Forgets which segments have been searched, but for the cuts that were found. `change(cut)` is called for each of these.
  template <typename Change>
  void begin_again(Change change)
  {
    m_sources.clear();
    for (Segment& segment : m_segments)
    {
      segment.is_searched = false;
      segment.cuts.clear();
      if (segment.own_cuts)
        for (Cut& cut : *segment.own_cuts)
          change(cut);
    }
  }

  // The nodes around which the cuts of its source divide a segment.
  std::vector<Nodes> sides_to_take_over(Index id) const
  {
    const Nodes& nodes = m_segments[id].nodes;
    std::vector<Nodes> result;
    for (const Cut& cut : m_segments[m_segments[id].source].cuts)
    {
      Nodes side;
      std::set_intersection(nodes.begin(), nodes.end(), cut.inner.begin(), cut.inner.end(), std::back_inserter(side));
      if (!side.empty() && side.size() < nodes.size())
        result.push_back(std::move(side));
    }
    return result;
  }

  // What is left of a segment beside the nodes of one side, in ascending order.
  Nodes other_side(Index id, const Nodes& side) const
  {
    Nodes result;
    const Nodes& nodes = m_segments[id].nodes;
    std::set_difference(nodes.begin(), nodes.end(), side.begin(), side.end(), std::back_inserter(result));
    return result;
  }

  // The segments on the inner and on the outer side of one of the cuts of a segment.
  std::pair<Index, Index> sides(Index id, std::size_t cut)
  {
    const Nodes& inner = m_segments[id].cuts[cut].inner;
    const Index inner_id = find_or_add(inner);
    return {inner_id, find_or_add(other_side(id, inner))};
  }

private:
  // Intersection over union; 0 if areas alone show that it is not above `least`.
  double overlap_of(Index a, Index b, double least) const
  {
    const Segment &first = m_segments[a], &second = m_segments[b];
    if ((std::min)(first.area, second.area) <= least * (std::max)(first.area, second.area))
      return 0;
    double common = 0;
    auto i = first.nodes.begin();
    auto j = second.nodes.begin();
    while (i != first.nodes.end() && j != second.nodes.end())
    {
      if (*i == *j)
        common += m_graph.area[*i];
      const bool advances_first = *i <= *j, advances_second = *j <= *i;
      i += advances_first;
      j += advances_second;
    }
    return common / (first.area + second.area - common);
  }

  const Weighted_dual_graph& m_graph;
  double m_least_overlap;
  std::deque<Segment> m_segments; // where they are, while others are added
  std::map<Nodes, Index> m_ids;
  std::vector<Index> m_sources; // that have been searched on their own, in that order
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEGMENT_POOL_H
