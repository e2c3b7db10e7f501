// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_NORMALIZE_POINTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_NORMALIZE_POINTS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

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

  // that of the points of both
  friend Largest_coordinate operator+(Largest_coordinate a, const Largest_coordinate& b)
  {
    a.m_largest = (std::max)(a.m_largest, b.m_largest);
    return a;
  }
  double value() const { return m_largest; }

private:
  double m_largest = 0;
};

inline Largest_coordinate largest_coordinate(const std::vector<Indexed_surface::Point_3>& points, bool is_parallel)
{
  return add_numbers(points.size(), is_parallel, Largest_coordinate(),
                     [&](Largest_coordinate& largest, std::size_t i) { largest.add(points[i]); });
}

inline Indexed_surface::Point_3 scaled_by_power_of_two(const Indexed_surface::Point_3& p, int exponent)
{
  return {std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent)};
}

// Scales the points by a power of two, which changes no digit, so that squares of areas neither overflow nor vanish; returns
// the exponent of the power that scales them back, at most `most`.
inline int scale_to_unit(std::vector<Indexed_surface::Point_3>& points,
                         int most = std::numeric_limits<double>::max_exponent,
                         bool is_parallel = false)
{
  const int exponent = (std::min)(largest_coordinate(points, is_parallel).exponent(), most);
  for_each_number(points.size(), is_parallel,
                  [&](std::size_t i) { points[i] = scaled_by_power_of_two(points[i], -exponent); });
  return exponent;
}

// Moves the box of the points to the origin and scales it by a power of two to [-1, 1]^3; returns the
// factor back. A power of two changes no digit, so that a mesh scaled by two gives the same numbers.
// The first scaling keeps the subtraction of coordinates near the largest double from overflowing. Only there
// the result fills [-2, 2]^3: the factor 2^1024 would be no double.
inline double normalize(std::vector<Indexed_surface::Point_3>& points, bool is_parallel = false)
{
  constexpr int most = std::numeric_limits<double>::max_exponent - 1;
  const int exponent = scale_to_unit(points, most, is_parallel);
  const Bbox_3 box = add_numbers(points.size(), is_parallel, Bbox_3(),
                                 [&](Bbox_3& all, std::size_t i) { all += points[i].bbox(); });
  const Indexed_surface::Vector_3 centre((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                                      (box.zmin() + box.zmax()) / 2);
  for_each_number(points.size(), is_parallel, [&](std::size_t i) { points[i] = points[i] - centre; });
  return std::ldexp(1., exponent + scale_to_unit(points, most - exponent, is_parallel));
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_NORMALIZE_POINTS_H
