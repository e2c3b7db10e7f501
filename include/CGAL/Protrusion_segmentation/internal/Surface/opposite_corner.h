// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_OPPOSITE_CORNER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_OPPOSITE_CORNER_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

namespace CGAL::Protrusion_segmentation::internal {

// The corner of the edge seen from the face beyond it, if there is one that is oriented alike; else `no_face()`.
inline Indexed_surface::Index
opposite_corner(const Indexed_surface& surface, Indexed_surface::Index face, Indexed_surface::Index corner)
{
  using Index = Indexed_surface::Index;
  const Index beyond = surface.neighbor(corner);
  if (beyond != Indexed_surface::no_face())
    for (Index c = surface.first_corner(beyond); c < surface.first_corner(beyond + 1); ++c)
      if (surface.neighbor(c) == face && surface.vertex(c) == surface.vertex(surface.next_corner(face, corner)) &&
          surface.vertex(surface.next_corner(beyond, c)) == surface.vertex(corner))
        return c;
  return Indexed_surface::no_face();
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_OPPOSITE_CORNER_H
