// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_EDGE_CONDUCTANCES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_EDGE_CONDUCTANCES_H

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

// The same for the corners of a surface.
class Edge_conductances
{
public:
  using Index = Indexed_surface::Index;

  explicit Edge_conductances(const Indexed_surface& surface)
    : m_surface(surface),
      m_shortest(shortest_length(surface.area(), surface.number_of_faces()))
  {}

  // `corner` is one of a face that has a neighbour there
  double operator()(Index face, Index corner) const
  {
    if (!(m_shortest > 0))
      return 1; // all points are equal, or nearly
    return conductance(m_surface.edge_length(face, corner),
                       m_surface.arc_length(face, m_surface.neighbor(corner)), m_shortest);
  }

private:
  const Indexed_surface& m_surface;
  double m_shortest;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_EDGE_CONDUCTANCES_H
