// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_IS_CONVEX_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_IS_CONVEX_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <CGAL/number_utils.h>

namespace CGAL::Protrusion_segmentation::internal {

// To which side of a face the next one bends at an edge: 1 if to that of its normal, -1 if to the other one, 0 if they are flat up to
// rounding.
inline int bend(const Indexed_surface& surface, Indexed_surface::Index face, Indexed_surface::Index corner)
{
  using Index = Indexed_surface::Index;
  constexpr double flat = 1e-6; // sine of the angle; coordinates are often of single precision
  const Index next = surface.neighbor(corner);
  const Indexed_surface::Vector_3 normal = surface.area_vector(face);
  int result = 0;
  double largest = flat * flat * normal.squared_length();
  for (Index c = surface.first_corner(next); c < surface.first_corner(next + 1); ++c)
  {
    const Indexed_surface::Vector_3 v = surface.point(surface.vertex(c)) - surface.point(surface.vertex(corner));
    const double height = v * normal, length = v.squared_length();
    if (CGAL::square(height) > largest * length)
    {
      largest = CGAL::square(height) / length;
      result = height > 0 ? 1 : -1;
    }
  }
  return result;
}

// Whether a closed surface bends to one side only and is one patch. Linear time, but one edge that bends to the other side ends it.
inline bool is_convex(const Indexed_surface& surface)
{
  using Index = Indexed_surface::Index;
  if (surface.has_patches())
    return false; // where they meet there is a seam
  int side = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
    {
      if (surface.neighbor(c) == Indexed_surface::no_face())
        return false;
      const int bent = bend(surface, f, c);
      if (bent * side < 0)
        return false;
      side = side == 0 ? bent : side;
    }
  return side != 0;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_IS_CONVEX_H
