// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_SURFACE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/canonical_order.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A surface whose faces are in an order that depends on where they are and not on the mesh.
class Canonical_surface
{
public:
  using Index = Indexed_surface::Index;

  // `unit`: what turns lengths of the arrays into those of the mesh
  Canonical_surface(Surface_arrays arrays, double unit, bool is_parallel = false)
    : m_unit(unit), m_position(canonical_order(arrays, is_parallel))
  {
    Surface_arrays ordered = Face_selector<Surface_arrays>(arrays)(m_position, [](Index) {});
    arrays = {}; // before memory is needed for more
    m_surface = std::move(ordered).to_surface(is_parallel);
  }

  const Indexed_surface& surface() const { return m_surface; }
  double unit() const { return m_unit; }
  // where each face of the surface is in the mesh
  const std::vector<Index>& positions() const { return m_position; }

  // The faces of the surface for faces given by their positions in the mesh.
  std::vector<Index> faces_at(const std::vector<Index>& positions) const
  {
    std::vector<Index> face(m_position.size()), result;
    for (Index f = 0; f < m_position.size(); ++f)
      face[m_position[f]] = f;
    for (Index p : positions)
      result.push_back(face[p]);
    return result;
  }

  // Values of the faces of the surface in the order of the mesh.
  std::vector<Index> in_order_of_mesh(const std::vector<Index>& values) const
  {
    std::vector<Index> result(values.size());
    for (Index f = 0; f < values.size(); ++f)
      result[m_position[f]] = values[f];
    return result;
  }

private:
  double m_unit;
  std::vector<Index> m_position;
  Indexed_surface m_surface;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_CANONICAL_SURFACE_H
