// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_TREE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_TREE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The segments of a connected surface as the nodes of a tree, and its borders as the arcs: each border separates the
// surface in two.
//
// The body is the segment without which no piece has more than half of the area. So what lies beyond a border, seen
// from the body, a protrusion with all that sticks out of it, never is the larger side.
class Segment_tree
{
public:
  using Index = Indexed_surface::Index;
  using Border = std::pair<Index, Index>; // between two segments

  // `areas`: of every segment
  Segment_tree(const std::vector<double>& areas, const std::vector<Border>& borders)
    : m_parents(areas.size()), m_border_to_parent(areas.size())
  {
    CGAL_precondition(borders.size() + 1 == areas.size());
    std::vector<std::vector<std::size_t>> borders_of(areas.size());
    for (std::size_t b = 0; b < borders.size(); ++b)
      for (Index s : {borders[b].first, borders[b].second})
        borders_of[s].push_back(b);
    hang_up(m_body, borders, borders_of, areas);
    // Of two halves that are equal but for rounding, each may be more than half seen from the other one.
    Index last = m_body;
    for (Index next = heavy_child(m_body); next != m_body && next != last; next = heavy_child(m_body))
    {
      last = std::exchange(m_body, next);
      hang_up(m_body, borders, borders_of, areas);
    }
  }

  Index body() const { return m_body; }
  // the segment that a segment sticks out of; the body is its own
  Index parent(Index segment) const { return m_parents[segment]; }
  // the number of the border between a segment, not the body, and its parent
  std::size_t border_to_parent(Index segment) const { return m_border_to_parent[segment]; }
  // of a segment with all that sticks out of it
  double area_beyond(Index segment) const { return m_areas[segment]; }

private:
  // Makes `body` the root.
  void hang_up(Index body,
               const std::vector<Border>& borders,
               const std::vector<std::vector<std::size_t>>& borders_of,
               const std::vector<double>& areas)
  {
    std::vector<Index> order(1, body);
    m_parents[body] = body;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t b : borders_of[order[i]])
      {
        const Index s = borders[b].first == order[i] ? borders[b].second : borders[b].first;
        if (s == m_parents[order[i]])
          continue;
        m_parents[s] = order[i];
        m_border_to_parent[s] = b;
        order.push_back(s);
      }
    CGAL_assertion(order.size() == m_parents.size());
    m_areas = areas;
    for (std::size_t i = order.size(); i-- > 1;)
      m_areas[m_parents[order[i]]] += m_areas[order[i]];
  }

  // The child of the root with more than half of the whole area; else the root itself.
  Index heavy_child(Index body) const
  {
    for (Index s = 0; s < m_parents.size(); ++s)
      if (s != body && m_parents[s] == body && 2 * m_areas[s] > m_areas[body])
        return s;
    return body;
  }

  Index m_body = 0;
  std::vector<Index> m_parents;
  std::vector<std::size_t> m_border_to_parent;
  std::vector<double> m_areas; // beyond the border to the parent
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_TREE_H
