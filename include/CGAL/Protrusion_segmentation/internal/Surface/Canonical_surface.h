// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_SURFACE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_without_small_components.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/inline.h>

#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A surface whose points are where its shape alone puts them, if it is connected, and whose faces are in an order that
// depends on where they are and not on the mesh.
class Canonical_surface
{
public:
  using Index = Indexed_surface::Index;

  // Of a connected surface.
  explicit Canonical_surface(Surface_arrays arrays, bool is_parallel = false);
  // Of a whole mesh; of several components in its coordinates, since they have no frame in common. For tips
  // and values, a face of a small component is the nearest face of the others.
  explicit Canonical_surface(Surface_without_small_components rest, bool is_parallel = false);

  const Indexed_surface& surface() const { return m_surface; }
  // what turns lengths of the surface into those of what it was made of
  double unit() const { return m_unit; }
  // where each face of the surface is in the mesh
  const std::vector<Index>& positions() const { return m_position; }

  // The faces of the surface for faces given by their positions in the mesh.
  std::vector<Index> faces_at(const std::vector<Index>& positions) const
  {
    return gather(m_face_at, positions);
  }

  // Values of the faces of the surface in the order of the mesh.
  std::vector<Index> in_order_of_mesh(const std::vector<Index>& values) const
  {
    return gather(values, m_face_at);
  }

private:
  void take_in_order(Surface_arrays& arrays, bool is_parallel);

  static std::vector<Index> gather(const std::vector<Index>& values, const std::vector<Index>& places)
  {
    std::vector<Index> result;
    result.reserve(places.size());
    for (Index place : places)
      result.push_back(values[place]);
    return result;
  }

  double m_unit;
  std::vector<Index> m_position;
  std::vector<Index> m_face_at; // of every face of the mesh; the nearest one if its component was left out
  Indexed_surface m_surface;
};

} // namespace CGAL::Protrusion_segmentation::internal

#if !defined(CGAL_PROTRUSION_SEGMENTATION_COMPILED) && !defined(CGAL_PROTRUSION_SEGMENTATION_COMPILED_SURFACES)
#include <CGAL/Protrusion_segmentation/internal/Surface/make_canonical_surface.h>
#endif

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_SURFACE_H
