// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEGMENT_POOL_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEGMENT_POOL_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// All sets of nodes that were segments in any of the segmentations looked at, each with its cuts. A set that comes up
// again is the same segment, whose cuts are not searched again.
class Segment_pool
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = Graph_partition::Nodes;

  struct Segment
  {
    Nodes nodes;           // ascending
    double area;
    std::vector<Cut> cuts; // best first
    bool is_searched = false;
  };

  // The graph must outlive the object.
  explicit Segment_pool(const Weighted_dual_graph& graph) : m_graph(graph) {}

  Index number_of_segments() const { return static_cast<Index>(m_segments.size()); }
  Segment& operator[](Index id) { return m_segments[id]; }
  const Segment& operator[](Index id) const { return m_segments[id]; }

  // The number of the segment with the given nodes, in ascending order.
  Index find_or_add(Nodes nodes)
  {
    const auto [found, is_new] = m_ids.emplace(std::move(nodes), number_of_segments());
    if (is_new)
    {
      m_segments.emplace_back();
      m_segments.back().nodes = found->first;
      m_segments.back().area = m_graph.area_of(found->first);
    }
    return found->second;
  }

  // What is left of a segment beside the nodes of one side, in ascending order.
  Nodes other_side(Index id, const Nodes& side) const
  {
    Nodes result;
    const Nodes& nodes = m_segments[id].nodes;
    std::set_difference(nodes.begin(), nodes.end(), side.begin(), side.end(), std::back_inserter(result));
    return result;
  }

  // The segments on the inner and on the outer side of a cut.
  std::pair<Index, Index> sides(Index id, const Nodes& inner)
  {
    const Index inner_id = find_or_add(inner);
    return {inner_id, find_or_add(other_side(id, inner))};
  }

private:
  const Weighted_dual_graph& m_graph;
  std::deque<Segment> m_segments; // where they are, while others are added
  std::map<Nodes, Index> m_ids;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEGMENT_POOL_H
