// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of users, which may be of any type with `x()`, `y()` and `z()`.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_USER_POINTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_USER_POINTS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <type_traits>

namespace CGAL::Protrusion_segmentation::internal {

// Coordinates that are of another type become `double`.
template <typename Point, typename OtherPoint>
Point point_as(const OtherPoint& p)
{
  if constexpr (std::is_same<Point, OtherPoint>::value)
    return p;
  else
    return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

template <typename Point>
Simple_cartesian<double>::Point_3 to_double_point(const Point& p)
{
  return point_as<Simple_cartesian<double>::Point_3>(p);
}

inline bool is_finite(const Simple_cartesian<double>::Point_3& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

// The map of the named parameter `vertex_point_map`, or the mesh's own.
template <typename FaceGraph, typename NamedParameters>
auto vertex_point_map(const FaceGraph& mesh, const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(CGAL::vertex_point, mesh));
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_USER_POINTS_H
