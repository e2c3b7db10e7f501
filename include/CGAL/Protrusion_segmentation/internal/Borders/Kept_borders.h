// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_KEPT_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_KEPT_BORDERS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Borders that stay where they are: all those of some segments, those between some two, and their edges at some vertices.
class Kept_borders
{
public:
  using Index = Indexed_surface::Index;

  Kept_borders(std::size_t number_of_segments, std::size_t number_of_vertices)
    : m_of_segment(number_of_segments, false), m_at_vertex(number_of_vertices, false)
  {}

  bool contains(Index s, Index t) const
  {
    return s != t && (m_of_segment[s] || m_of_segment[t] || m_between.count(std::minmax(s, t)) > 0);
  }

  // An edge between faces of two segments.
  bool contains_edge(Index s, Index t, Index u, Index v) const
  {
    return s != t && (m_at_vertex[u] || m_at_vertex[v] || contains(s, t));
  }

  bool contains_segment(Index s) const { return m_of_segment[s]; }

  std::size_t number_of_segments() const
  {
    return static_cast<std::size_t>(std::count(m_of_segment.begin(), m_of_segment.end(), true));
  }

  // Each of these returns whether it was not kept before.
  bool keep_segment(Index s) { return keep(m_of_segment, s); }
  bool keep_at_vertex(Index v) { return keep(m_at_vertex, v); }
  bool keep_between(Index s, Index t) { return !contains(s, t) && m_between.insert(std::minmax(s, t)).second; }

private:
  static bool keep(std::vector<bool>& is_kept, Index i)
  {
    const bool is_new = !is_kept[i];
    is_kept[i] = true;
    return is_new;
  }

  std::vector<bool> m_of_segment;
  std::vector<bool> m_at_vertex;
  std::set<std::pair<Index, Index>> m_between; // the lower one first
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_KEPT_BORDERS_H
