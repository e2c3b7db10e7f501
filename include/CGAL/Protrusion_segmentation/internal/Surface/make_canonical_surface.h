// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_MAKE_CANONICAL_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_MAKE_CANONICAL_SURFACE_H

#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/canonical_frame.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/canonical_order.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>

#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

CGAL_PROTRUSION_SEGMENTATION_INLINE
Canonical_surface::Canonical_surface(Surface_arrays arrays, bool is_parallel)
  : m_unit(move_to_canonical_frame(arrays, is_parallel)), m_position(canonical_order(arrays, is_parallel))
{
  take_in_order(arrays, is_parallel);
}

CGAL_PROTRUSION_SEGMENTATION_INLINE
Canonical_surface::Canonical_surface(Surface_without_small_components rest, bool is_parallel)
  : m_unit(rest.is_connected ? move_to_canonical_frame(rest.arrays, is_parallel)
                             : normalize(rest.arrays.points)),
    m_position(canonical_order(rest.arrays, is_parallel))
{
  take_in_order(rest.arrays, is_parallel);
  if (rest.nearest_faces.empty())
    return;
  std::vector<Index> face(m_position.size()); // of the rest
  for (Index f = 0; f < m_position.size(); ++f)
    face[m_position[f]] = f;
  for (Index& position : m_position)
    position = rest.faces[position];
  for (Index nearest_face : rest.nearest_faces)
    m_face_at.push_back(face[nearest_face]);
}

CGAL_PROTRUSION_SEGMENTATION_INLINE
void Canonical_surface::take_in_order(Surface_arrays& arrays, bool is_parallel)
{
  Surface_arrays ordered = Face_selector<Surface_arrays>(arrays, is_parallel)(m_position);
  arrays = {}; // before memory is needed for more
  m_surface = std::move(ordered).to_surface(is_parallel);
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_MAKE_CANONICAL_SURFACE_H
