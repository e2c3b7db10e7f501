// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_POLYGON_AREA_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_POLYGON_AREA_H

#include "reading/Mesh.h"

#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <cmath>
#include <vector>

namespace tool
{

// Also of huge and tiny polygons, whose squared area is no number.
inline double polygon_area(std::vector<Point> corners)
{
  namespace internal = CGAL::Protrusion_segmentation::internal;

  const int exponent = internal::scale_to_unit(corners);
  return std::ldexp(std::sqrt(internal::polygon_area_vector(corners).squared_length()), 2 * exponent);
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_POLYGON_AREA_H
