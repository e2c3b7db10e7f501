// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SURFACE_WITHOUT_SMALL_COMPONENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SURFACE_WITHOUT_SMALL_COMPONENTS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/inline.h>

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A surface without its small components and the walls of its cavities. If there are none, it is the whole surface, and both
// lists are empty.
struct Surface_without_small_components
{
  using Index = Indexed_surface::Index;

  Surface_arrays arrays;
  // for every face of this surface its number in the whole surface
  std::vector<Index> faces;
  // for every face of the whole surface one of this: itself, the one nearest to its small component, or the nearest one of
  // the outer wall around its cavity
  std::vector<Index> nearest_faces;
  std::size_t number_of_small_components = 0;
  bool is_connected = false;
};

// Coordinates may be of any size. Takes linear time, and O(n log n) for n faces if there are several components.
Surface_without_small_components leave_out_small_components(Surface_arrays surface);

} // namespace CGAL::Protrusion_segmentation::internal

#if !defined(CGAL_PROTRUSION_SEGMENTATION_COMPILED) && !defined(CGAL_PROTRUSION_SEGMENTATION_COMPILED_SURFACES)
#include <CGAL/Protrusion_segmentation/internal/Surface/leave_out_small_components.h>
#endif

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SURFACE_WITHOUT_SMALL_COMPONENTS_H
