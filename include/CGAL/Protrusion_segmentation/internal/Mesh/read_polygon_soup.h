// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_READ_POLYGON_SOUP_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_READ_POLYGON_SOUP_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/user_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

template <typename Range>
using Element = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

// From the elements of a range to their points.
template <typename PointRange, typename NamedParameters>
auto point_map_of(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::point_map),
                                      Identity_property_map<Element<PointRange>>());
}

template <typename PointRange, typename PointMap>
std::vector<Polygon_soup::Point_3> read_soup_points(const PointRange& points, PointMap point_map)
{
  std::vector<Polygon_soup::Point_3> result;
  for (const auto& element : points)
    result.push_back(to_double_point(get(point_map, element)));
  return result;
}

// A corner that is a point, whatever the integer type.
template <typename Integer>
std::size_t checked_corner(Integer corner, std::size_t polygon, std::size_t number_of_points)
{
  static_assert(std::is_integral<Integer>::value && !std::is_same<Integer, bool>::value,
                "a corner of a polygon must be an integer, the index of a point");
  bool is_negative = false;
  if constexpr (std::is_signed<Integer>::value)
    is_negative = corner < 0;
  if (is_negative || static_cast<std::make_unsigned_t<Integer>>(corner) >= number_of_points)
    throw std::invalid_argument("polygons: polygon " + std::to_string(polygon) + " has the corner " +
                                std::to_string(corner) + ", but there are " +
                                std::to_string(number_of_points) + " points");
  return static_cast<std::size_t>(corner);
}

template <typename PolygonRange>
Polygons read_polygons(const PolygonRange& polygons, std::size_t number_of_points)
{
  Polygons result;
  std::vector<std::size_t> corners;
  for (const auto& polygon : polygons)
  {
    corners.clear();
    for (const auto corner : polygon)
      corners.push_back(checked_corner(corner, result.size(), number_of_points));
    result.add(corners);
  }
  if (result.size() == 0)
    throw std::invalid_argument("polygons: there are none");
  return result;
}

// Points that are corners must be finite. All others do not matter, and move to the origin if they are not.
inline void check_points(Polygon_soup& soup)
{
  std::vector<bool> is_corner(soup.points.size(), false);
  for (std::size_t c = 0; c < soup.polygons.number_of_corners(); ++c)
    is_corner[soup.polygons.corner(c)] = true;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
  {
    Polygon_soup::Point_3& p = soup.points[i];
    if (is_finite(p))
      continue;
    if (is_corner[i])
      throw std::invalid_argument("points: point " + std::to_string(i) +
                                  " has a coordinate that is not finite");
    p = ORIGIN;
  }
}

// Nothing if it is to be found.
template <typename NamedParameters>
std::optional<double> snapping_tolerance(const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters,
                                                 internal_np::snapping_tolerance_t>::value)
    return std::nullopt;
  else
  {
    const double tolerance = CGAL::to_double(parameters::get_parameter(np, internal_np::snapping_tolerance));
    if (!(tolerance >= 0 && std::isfinite(tolerance)))
      throw std::invalid_argument("snapping_tolerance: " + std::to_string(tolerance) + " is no distance");
    return tolerance;
  }
}

// With the checks of both arguments.
template <typename PointRange, typename PointMap, typename PolygonRange>
Polygon_soup read_polygon_soup(const PointRange& points, PointMap point_map, const PolygonRange& polygons)
{
  Polygon_soup soup;
  soup.points = read_soup_points(points, point_map);
  soup.polygons = read_polygons(polygons, soup.points.size());
  check_points(soup);
  return soup;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_READ_POLYGON_SOUP_H
