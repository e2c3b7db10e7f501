// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CONDUCTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CONDUCTANCE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Protrusion_segmentation::internal {

// The weights of the finite-volume Laplacian of the face dual graph: what flows between two faces in proportion to the
// difference of their values, the length of their edge relative to the distance of their centroids. Independent of
// scale.
//
// Lengths below a hundredth of that of a mean face count as that much: no weight is 0 or infinite, and slivers, whose
// centroids nearly coincide, make no solver slow.
inline double shortest_length(double area, Indexed_surface::Index number_of_faces)
{
  return 0.01 * std::sqrt(area / (std::max)(number_of_faces, Indexed_surface::Index(1)));
}

template <typename Number>
Number conductance(Number edge_length, Number arc_length, Number shortest)
{
  return (std::max)(edge_length, shortest) / (std::max)(arc_length, shortest);
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CONDUCTANCE_H
