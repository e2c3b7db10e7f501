// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_POLYGON_SOUP_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_POLYGON_SOUP_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygons.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Polygons whose corners are indices of points, whatever is wrong with them.
struct Polygon_soup
{
  using Point_3 = Simple_cartesian<double>::Point_3;
  using Vector_3 = Simple_cartesian<double>::Vector_3;

  std::vector<Point_3> points;
  Polygons polygons;
};

// The points of corners, or what else is given for each point.
template <typename T, typename Corners>
std::vector<T> of_corners(const std::vector<T>& of_points, const Corners& corners)
{
  std::vector<T> result;
  for (const std::size_t corner : corners)
    result.push_back(of_points[corner]);
  return result;
}

// Along the normal of the polygon and as long as its area is large.
template <typename Corners>
Polygon_soup::Vector_3 area_vector(const std::vector<Polygon_soup::Point_3>& points,
                                   const Corners& corners)
{
  return polygon_area_vector(of_corners(points, corners));
}

// Points that lie on each other are at one place, which is named by the first of them.
inline std::vector<std::size_t> places(const std::vector<Polygon_soup::Point_3>& points)
{
  // with their first coordinates: a comparison seldom has to look up the points
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    order.emplace_back(points[i].x(), i);
  std::sort(order.begin(), order.end(),
            [&](const auto& a, const auto& b)
            {
              if (a.first != b.first)
                return a.first < b.first;
              const Polygon_soup::Point_3 &p = points[a.second], &q = points[b.second];
              return p < q || (p == q && a.second < b.second);
            });
  std::vector<std::size_t> result(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const std::size_t point = order[i].second;
    const bool is_new = i == 0 || points[point] != points[order[i - 1].second];
    result[point] = is_new ? point : result[order[i - 1].second];
  }
  return result;
}

// Scales the points by a power of two, which changes no digit, so that squares of areas neither overflow nor vanish. Points
// without a polygon do not count: a far one would make the rest tiny. Returns the exponent of the power that scales back.
inline int scale_to_unit(Polygon_soup& soup)
{
  Largest_coordinate largest;
  for (const std::size_t corner : soup.polygons.corners())
    largest.add(soup.points[corner]);
  for (Polygon_soup::Point_3& p : soup.points)
    p = scaled_by_power_of_two(p, -largest.exponent());
  return largest.exponent();
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_POLYGON_SOUP_H
