// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_FACE_CHOICE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_FACE_CHOICE_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The polygons that become faces, and the faces that label those that do not.
struct Face_choice
{
  std::vector<std::size_t> kept;        // polygons, ascending
  std::vector<std::size_t> label_giver; // of each polygon: a position in `kept`
  Polygons polygons;                    // those kept, without corners twice in a row
  std::vector<bool> has_double;         // for each kept one: is there another one with the same corners?
  std::size_t degenerate_polygons = 0;
  std::size_t duplicate_polygons = 0;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_FACE_CHOICE_H
