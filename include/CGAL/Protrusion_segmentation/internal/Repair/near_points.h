// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEAR_POINTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEAR_POINTS_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The distance up to which corners, of which all points are some, are taken for equal if none is given. Numbers rounded to
// single precision differ by some units in the last place. Other files differ by about a millionth of the size, in each
// coordinate and to both sides.
template <typename Points>
double automatic_tolerance(const Points& points)
{
  constexpr double share_of_size = 4e-6, units_in_last_place = 4;
  Bbox_3 box;
  bool is_single_precision = true;
  for (const Polygon_soup::Point_3& p : points)
  {
    box += p.bbox();
    for (const double x : {p.x(), p.y(), p.z()})
      is_single_precision = is_single_precision && static_cast<double>(static_cast<float>(x)) == x;
  }
  const double size = (std::max)({box.x_span(), box.y_span(), box.z_span()});
  const double largest = (std::max)(
    {-box.xmin(), -box.ymin(), -box.zmin(), box.xmax(), box.ymax(), box.zmax()});
  const double unit = is_single_precision ? std::ldexp(largest, -std::numeric_limits<float>::digits) : 0;
  return (std::max)(share_of_size * size, units_in_last_place * unit);
}

// A point near a side, between its ends or at one of them.
struct Near_point
{
  double distance;
  double position; // along the side, 0 to 1
  std::size_t side;
  std::size_t point;
};

// All of some points, those of borders. A side is given by the points at its ends; points near it are no farther than half its
// length.
inline std::vector<Near_point> near_points(const std::vector<Polygon_soup::Point_3>& points,
                                           const std::vector<std::array<std::size_t, 2>>& sides,
                                           const std::set<std::size_t>& points_of_borders,
                                           double tolerance)
{
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  const auto tolerance_of = [&](std::size_t side)
  {
    return (std::min)(tolerance,
                      std::sqrt(squared_distance(points[sides[side][0]], points[sides[side][1]])) / 2);
  };
  std::vector<Box> boxes, boxes_of_points;
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    const Bbox_3 b = points[sides[s][0]].bbox() + points[sides[s][1]].bbox();
    const double t = tolerance_of(s);
    boxes.emplace_back(
      Bbox_3(b.xmin() - t, b.ymin() - t, b.zmin() - t, b.xmax() + t, b.ymax() + t, b.zmax() + t), s);
  }
  for (const std::size_t point : points_of_borders)
    boxes_of_points.emplace_back(points[point].bbox(), point);
  std::vector<Near_point> result;
  box_intersection_d(boxes.begin(), boxes.end(), boxes_of_points.begin(), boxes_of_points.end(),
                     [&](const Box& side_box, const Box& point_box)
                     {
                       const std::size_t side = side_box.info(), point = point_box.info();
                       const auto& [start, end] = sides[side];
                       if (point == start || point == end)
                         return;
                       const Polygon_soup::Vector_3 along = points[end] - points[start],
                                                    to_point = points[point] - points[start];
                       const double position = (std::min)(
                         (std::max)(to_point * along / along.squared_length(), 0.), 1.);
                       const double distance = std::sqrt((to_point - position * along).squared_length());
                       if (distance <= tolerance_of(side))
                         result.push_back({distance, position, side, point});
                     });
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEAR_POINTS_H
