// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CORNER_FANS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CORNER_FANS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Kept_borders.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <limits>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

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

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CORNER_FANS_H
