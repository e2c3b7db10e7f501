// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Area and centroid of a polygon in space, given as a range of its corners with `size()`, at least 1, and
// `operator[]`, which returns a point.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_POLYGON_MEASURES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_POLYGON_MEASURES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Protrusion_segmentation::internal {

struct Polygon_measures
{
  double area = 0;
  Simple_cartesian<double>::Point_3 centroid = ORIGIN;
};

// Normal to the polygon and as long as its area: half the sum of the vector products of consecutive corners.
// Its length is the area of a plane polygon, convex or not, and otherwise that of the projection along the
// mean normal.
template <typename Corners>
Simple_cartesian<double>::Vector_3 polygon_area_vector(const Corners& corners)
{
  CGAL_precondition(corners.size() > 0);
  const Simple_cartesian<double>::Point_3 origin = corners[0];
  Simple_cartesian<double>::Vector_3 sum(0, 0, 0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross_product(corners[i] - origin, corners[i + 1] - origin);
  return sum / 2;
}

// The mean of the three corners.
template <typename Corners>
Simple_cartesian<double>::Point_3 triangle_centroid(const Corners& corners)
{
  const Simple_cartesian<double>::Point_3 origin = corners[0];
  return origin + ((corners[1] - origin) + (corners[2] - origin)) / 3.;
}

// The centroid of the fan of triangles around the first corner, each triangle signed by the normal: right for
// every simple planar polygon, convex or not. The mean of the corners where that is far off, as for folded or
// crossed polygons, the signs of whose triangles nearly cancel, and where there is no area.
template <typename Corners>
Simple_cartesian<double>::Point_3 polygon_centroid(const Corners& corners,
                                                   const Simple_cartesian<double>::Vector_3& normal,
                                                   double area)
{
  CGAL_precondition(corners.size() > 0);
  if (corners.size() == 3)
    return triangle_centroid(corners);
  using Vector_3 = Simple_cartesian<double>::Vector_3;
  const Simple_cartesian<double>::Point_3 origin = corners[0];
  Vector_3 sum(0, 0, 0), moment(0, 0, 0);
  // squared: the centroid of a simple polygon is no farther from a corner than another one
  double reach = 0;
  for (std::size_t i = 1; i < corners.size(); ++i)
  {
    const Vector_3 v = corners[i] - origin;
    const Vector_3 u = corners[i - 1] - origin;
    sum += v;
    moment += (u + v) * ((cross_product(u, v) * normal) / (6 * area * area));
    reach = (std::max)(reach, v.squared_length());
  }
  // the comparison is false for the moment without an area, which is no number
  const bool is_moment_right = corners.size() > 3 && moment.squared_length() <= reach;
  return origin + (is_moment_right ? moment : sum / static_cast<double>(corners.size()));
}

// The corners of a face of a surface, as such a range.
template <typename Surface>
struct Corners_of_face
{
  using Index = std::uint32_t;

  const Surface& surface;
  Index face;

  std::size_t size() const { return surface.first_corner(face + 1) - surface.first_corner(face); }
  const Simple_cartesian<double>::Point_3& operator[](std::size_t i) const
  {
    return surface.point(surface.vertex(surface.first_corner(face) + static_cast<Index>(i)));
  }
};

template <typename Corners>
Polygon_measures measure_polygon(const Corners& corners)
{
  const Simple_cartesian<double>::Vector_3 normal = polygon_area_vector(corners);
  const double area = std::sqrt(normal.squared_length());
  return {area, polygon_centroid(corners, normal, area)};
}

template <typename Surface>
Simple_cartesian<double>::Point_3 centroid_of_face(const Surface& surface, std::uint32_t face)
{
  return measure_polygon(Corners_of_face<Surface>{surface, face}).centroid;
}

// Calls `visit(p, q, r)` for the triangles of the fan around the first corner.
template <typename Corners, typename Visit>
void for_each_triangle_of_fan(const Corners& corners, Visit visit)
{
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    visit(corners[0], corners[i], corners[i + 1]);
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_POLYGON_MEASURES_H
