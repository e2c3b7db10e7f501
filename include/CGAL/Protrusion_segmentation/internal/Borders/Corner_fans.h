// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CORNER_FANS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CORNER_FANS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Borders that stay where they are: all those of some segments, those between some two, and their edges at some vertices.
class Kept_borders
{
public:
  using Index = Indexed_surface::Index;

  bool contains(Index s, Index t) const
  {
    return s != t && (contains_segment(s) || contains_segment(t) || m_between.count(std::minmax(s, t)) > 0);
  }

  // An edge between faces of two segments.
  bool contains_edge(Index s, Index t, Index u, Index v) const
  {
    return s != t && (m_at_vertices.count(u) > 0 || m_at_vertices.count(v) > 0 || contains(s, t));
  }

  bool contains_segment(Index s) const { return m_of_segments.count(s) > 0; }

  std::size_t number_of_segments() const { return m_of_segments.size(); }

  // Each of these returns whether it was not kept before.
  bool keep_segment(Index s) { return m_of_segments.insert(s).second; }
  bool keep_at_vertex(Index v) { return m_at_vertices.insert(v).second; }
  bool keep_between(Index s, Index t) { return !contains(s, t) && m_between.insert(std::minmax(s, t)).second; }

private:
  std::set<Index> m_of_segments, m_at_vertices;
  std::set<std::pair<Index, Index>> m_between; // the lower one first
};

// The corners of faces at a vertex that see each other: those of one fan. Kept borders part the fans of a vertex, as the
// boundary of the surface does, and nothing is smoothed over them.
class Corner_fans
{
public:
  using Index = Indexed_surface::Index;

  Corner_fans(const Indexed_surface& surface, const std::vector<Index>& segment_of_face, const Kept_borders& kept)
    : m_fan_of_corner(surface.number_of_corners())
  {
    Disjoint_sets sets(surface.number_of_corners());
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      {
        const Index g = surface.neighbor(c), next = surface.next_corner(f, c);
        if (g == Indexed_surface::no_face() || f > g ||
            kept.contains_edge(segment_of_face[f], segment_of_face[g], surface.vertex(c), surface.vertex(next)))
          continue;
        sets.union_set(c, corner_at(surface, g, surface.vertex(c)));
        sets.union_set(next, corner_at(surface, g, surface.vertex(next)));
      }
    number_fans(sets);
  }

  Index number_of_fans() const { return m_number_of_fans; }
  Index operator[](Index corner) const { return m_fan_of_corner[corner]; }
  const std::vector<Index>& of_corners() const { return m_fan_of_corner; }

private:
  static Index corner_at(const Indexed_surface& surface, Index face, Index vertex)
  {
    Index corner = surface.first_corner(face);
    while (surface.vertex(corner) != vertex)
      ++corner;
    return corner;
  }

  void number_fans(Disjoint_sets& sets)
  {
    const Index none = (std::numeric_limits<Index>::max)();
    std::vector<Index> number(m_fan_of_corner.size(), none);
    for (Index c = 0; c < m_fan_of_corner.size(); ++c)
    {
      Index& fan = number[sets.find_set(c)];
      if (fan == none)
        fan = m_number_of_fans++;
      m_fan_of_corner[c] = fan;
    }
  }

  std::vector<Index> m_fan_of_corner;
  Index m_number_of_fans = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CORNER_FANS_H
