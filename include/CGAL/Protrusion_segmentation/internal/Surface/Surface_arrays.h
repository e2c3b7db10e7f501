// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SURFACE_ARRAYS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SURFACE_ARRAYS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A surface as its arrays alone, with the accessors of `Indexed_surface`.
struct Surface_arrays
{
  using Index = Indexed_surface::Index;

  std::vector<Indexed_surface::Point_3> points;
  std::vector<Index> corner_begin = std::vector<Index>(1, 0);
  std::vector<Index> corner_vertices;
  std::vector<Index> corner_neighbors;
  std::vector<Index> patches; // of the faces, or none

  Index number_of_faces() const { return static_cast<Index>(corner_begin.size() - 1); }
  Index number_of_vertices() const { return static_cast<Index>(points.size()); }
  const Indexed_surface::Point_3& point(Index vertex) const { return points[vertex]; }
  Index first_corner(Index face) const { return corner_begin[face]; }
  Index vertex(Index corner) const { return corner_vertices[corner]; }
  Index neighbor(Index corner) const { return corner_neighbors[corner]; }
  bool has_patches() const { return !patches.empty(); }
  Index patch(Index face) const { return patches[face]; }

  // leaves the arrays empty
  Indexed_surface to_surface(bool is_parallel = false) &&
  {
    return Indexed_surface(std::move(points), std::move(corner_begin), std::move(corner_vertices),
                           std::move(corner_neighbors), is_parallel, std::move(patches));
  }
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SURFACE_ARRAYS_H
