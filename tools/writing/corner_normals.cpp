// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/corner_normals.h"

#include "writing/unit_ball.h"

#include <CGAL/Kernel/global_functions.h>

#include <cmath>
#include <cstddef>

namespace tool {
namespace {

using Vector = CGAL::Simple_cartesian<double>::Vector_3;

constexpr double cosine_of_crease = 0.5; // 60 degrees, as three.js' toCreasedNormals() has it

Vector normalized(const Vector& vector)
{
  const double length = std::sqrt(vector.squared_length());
  return length > 0 ? vector / length : vector;
}

// Around a point with more faces, such as the tip of a cone, each keeps its own normal: all pairs would be too many.
constexpr std::size_t most_faces_around_a_point = 100;

// Twice the area times the normal, of the polygon in the unit ball, where products stay in the range of numbers.
std::vector<Vector> area_vectors(const Polygon_soup& soup)
{
  const Ball ball = bounding_ball(soup.points);
  const auto offset = [&](std::size_t point)
  {
    const Point& p = soup.points[point];
    return Vector((p.x() - ball.center[0]) / ball.radius, (p.y() - ball.center[1]) / ball.radius,
                  (p.z() - ball.center[2]) / ball.radius);
  };
  std::vector<Vector> result;
  for (const Corners& polygon : soup.polygons)
  {
    Vector sum = CGAL::NULL_VECTOR;
    for (std::size_t i = 2; i < polygon.size(); ++i)
      sum = sum + CGAL::cross_product(offset(polygon[i - 1]) - offset(polygon[0]),
                                      offset(polygon[i]) - offset(polygon[0]));
    result.push_back(sum);
  }
  return result;
}

} // namespace

std::vector<std::vector<Normal>> corner_normals(const Polygon_soup& soup)
{
  const std::vector<Vector> areas = area_vectors(soup);
  std::vector<std::vector<std::size_t>> faces_around(soup.points.size());
  for (std::size_t face = 0; face < soup.polygons.size(); ++face)
    for (const std::size_t corner : soup.polygons[face])
      faces_around[corner].push_back(face);
  std::vector<Vector> normals;
  for (const Vector& area : areas)
    normals.push_back(normalized(area));
  std::vector<std::vector<Normal>> result(soup.polygons.size());
  for (std::size_t face = 0; face < soup.polygons.size(); ++face)
    for (const std::size_t corner : soup.polygons[face])
    {
      Vector sum = areas[face];
      if (faces_around[corner].size() <= most_faces_around_a_point)
        for (const std::size_t other : faces_around[corner])
          if (other != face && normals[face] * normals[other] >= cosine_of_crease)
            sum = sum + areas[other];
      const Vector normal = sum == CGAL::NULL_VECTOR ? Vector(0, 0, 1)
                                                     : normalized(sum); // any for no area
      result[face].push_back({float(normal.x()), float(normal.y()), float(normal.z())});
    }
  return result;
}

} // namespace tool
