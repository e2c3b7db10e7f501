// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_NORMALIZE_POINTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_NORMALIZE_POINTS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The largest coordinate of points that come one by one.
class Largest_coordinate
{
public:
  void add(const Indexed_surface::Point_3& p)
  {
    m_largest = (std::max)({m_largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  }

  // The least e for which all coordinates are below 2^e; 0 if they are all zero.
  int exponent() const
  {
    int result = 0;
    std::frexp(m_largest, &result);
    return result;
  }

private:
  double m_largest = 0;
};

inline Indexed_surface::Point_3 scaled_by_power_of_two(const Indexed_surface::Point_3& p, int exponent)
{
  return {std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent)};
}

// Scales the points by a power of two, which changes no digit, so that squares of areas neither overflow nor vanish; returns
// the exponent of the power that scales them back, at most `most`.
inline int scale_to_unit(std::vector<Indexed_surface::Point_3>& points,
                         int most = std::numeric_limits<double>::max_exponent)
{
  Largest_coordinate largest;
  for (const Indexed_surface::Point_3& p : points)
    largest.add(p);
  const int exponent = (std::min)(largest.exponent(), most);
  for (Indexed_surface::Point_3& p : points)
    p = scaled_by_power_of_two(p, -exponent);
  return exponent;
}

// Moves the box of the points to the origin and scales it by a power of two to [-1, 1]^3; returns the
// factor back. A power of two changes no digit, so that a mesh scaled by two gives the same numbers.
// The first scaling keeps the subtraction of coordinates near the largest double from overflowing. Only there
// the result fills [-2, 2]^3: the factor 2^1024 would be no double.
inline double normalize(std::vector<Indexed_surface::Point_3>& points)
{
  constexpr int most = std::numeric_limits<double>::max_exponent - 1;
  const int exponent = scale_to_unit(points, most);
  const Bbox_3 box = bbox_3(points.begin(), points.end());
  const Indexed_surface::Vector_3 centre((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                                      (box.zmin() + box.zmax()) / 2);
  for (Indexed_surface::Point_3& p : points)
    p = p - centre;
  return std::ldexp(1., exponent + scale_to_unit(points, most - exponent));
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_NORMALIZE_POINTS_H
