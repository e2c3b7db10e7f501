// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_SURFACE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_without_small_components.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/inline.h>

#include <algorithm>
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
    std::vector<Index> face = m_face_at;
    face.resize((std::max)(face.size(), m_position.size()));
    for (Index f = 0; f < m_position.size(); ++f)
      face[m_position[f]] = f;
    std::vector<Index> result;
    for (Index p : positions)
      result.push_back(face[p]);
    return result;
  }

  // Values of the faces of the surface in the order of the mesh.
  std::vector<Index> in_order_of_mesh(const std::vector<Index>& values) const
  {
    std::vector<Index> result;
    if (!m_face_at.empty())
    {
      for (Index f : m_face_at)
        result.push_back(values[f]);
      return result;
    }
    result.resize(values.size());
    for (Index f = 0; f < values.size(); ++f)
      result[m_position[f]] = values[f];
    return result;
  }

private:
  void take_in_order(Surface_arrays& arrays, bool is_parallel);

  double m_unit;
  std::vector<Index> m_position;
  std::vector<Index> m_face_at; // of every face of the mesh, if there are small components
  Indexed_surface m_surface;
};

} // namespace CGAL::Protrusion_segmentation::internal

#if !defined(CGAL_PROTRUSION_SEGMENTATION_COMPILED) && !defined(CGAL_PROTRUSION_SEGMENTATION_COMPILED_SURFACES)
#include <CGAL/Protrusion_segmentation/internal/Surface/make_canonical_surface.h>
#endif

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_SURFACE_H
