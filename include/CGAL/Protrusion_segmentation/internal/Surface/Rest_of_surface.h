// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_REST_OF_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_REST_OF_SURFACE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/inline.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// What is left of a surface without its specks, and how its faces stand for those of specks. If there is no speck, it is the
// whole surface, and both lists are empty.
struct Rest_of_surface
{
  using Index = Indexed_surface::Index;

  Surface_arrays arrays;
  // for every face of the rest its number in the whole surface
  std::vector<Index> faces;
  // for every face of the whole surface a face of the rest: itself, or the one nearest to its speck
  std::vector<Index> stand_ins;
  std::size_t number_of_specks = 0;
  bool is_connected = false;
};

// Coordinates may be of any size. Takes linear time, and O(n log n) for n faces if there are specks.
Rest_of_surface leave_out_specks(Surface_arrays surface);

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#ifndef CGAL_PROTRUSION_SEGMENTATION_COMPILED
#include <CGAL/Protrusion_segmentation/internal/Surface/leave_out_specks.h>
#endif

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_REST_OF_SURFACE_H
