// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/hulls.h"

#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <set>

namespace tool {
namespace {

namespace internal = CGAL::Protrusion_segmentation::internal;

// Of points whose products neither overflow nor vanish.
Polygon_soup hull_of(const std::set<Point>& points, int exponent)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> corners;
  for (const Point& p : points)
    corners.emplace_back(p.x(), p.y(), p.z());
  CGAL::Surface_mesh<Kernel::Point_3> hull;
  CGAL::convex_hull_3(corners.begin(), corners.end(), hull);
  Polygon_soup soup;
  for (const auto v : hull.vertices())
  {
    const Kernel::Point_3& p = hull.point(v);
    soup.points.push_back(internal::scaled_by_power_of_two(Point(p.x(), p.y(), p.z()), exponent));
  }
  for (const auto f : hull.faces())
    soup.polygons.add(vertices_around_face(hull.halfedge(f), hull));
  return soup;
}

} // namespace

std::vector<Polygon_soup> convex_hulls(const Mesh& mesh,
                                       const std::vector<std::size_t>& segment_of_face,
                                       std::size_t number_of_segments)
{
  std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  const int exponent = internal::scale_to_unit(points);
  std::vector<std::set<Point>> points_of(number_of_segments);
  for (const Face face : faces(mesh))
    for (const auto v : vertices_around_face(mesh.halfedge(face), mesh))
      points_of[segment_of_face[face]].insert(points[v]);
  std::vector<Polygon_soup> hulls;
  for (const std::set<Point>& of_segment : points_of)
    hulls.push_back(hull_of(of_segment, exponent));
  return hulls;
}

} // namespace tool
