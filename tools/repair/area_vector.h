// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPAIR_AREA_VECTOR_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPAIR_AREA_VECTOR_H

#include "reading/Polygon_soup.h"

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

namespace tool
{

using Vector = CGAL::Simple_cartesian<double>::Vector_3;

// Along the normal of the polygon and as long as its area is large.
inline Vector area_vector(const std::vector<Point>& points, const Polygon& polygon)
{
  Vector sum(0, 0, 0);
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum = sum + CGAL::cross_product(points[polygon[i - 1]] - points[polygon[0]],
                                    points[polygon[i]] - points[polygon[0]]);
  return sum / 2;
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_REPAIR_AREA_VECTOR_H
