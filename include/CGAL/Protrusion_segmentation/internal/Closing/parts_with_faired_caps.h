// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_PARTS_WITH_FAIRED_CAPS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_PARTS_WITH_FAIRED_CAPS_H

#if defined(CGAL_EIGEN3_ENABLED) || defined(DOXYGEN_RUNNING)

#include <CGAL/Protrusion_segmentation/Closed_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Capper.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/triangulate_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/bounding_ball.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::faired_caps {

using Exact_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Vector = Exact_predicates_inexact_constructions_kernel::Vector_3;
using Part = CGAL::Surface_mesh<Exact_point>; // CGAL's functions for holes want exact predicates
using Vertex = Part::Vertex_index;
using Halfedge = Part::Halfedge_index;
using Edge = std::pair<Exact_point, Exact_point>;
using Point = Mesh_to_close::Point;
using Face = Mesh_to_close::Face_index; // that of a part is the same

// The square of a width to the square of a length: far above what rounding makes of nothing.
constexpr double no_width = 1e-20;

// From the center of a part, in a ball of radius 1 to 2: beyond a half ball on the widest hole that it could have.
constexpr double farthest_cap = 4;

inline Exact_point exact(const Point& point)
{
  return Exact_point(point.x(), point.y(), point.z());
}

// Of the mesh, in the direction of the halfedges without a face.
inline std::set<Edge> border_edges(const Mesh_to_close& mesh)
{
  std::set<Edge> result;
  for (const auto h : halfedges(mesh))
    if (mesh.is_border(h))
      result.emplace(exact(mesh.point(mesh.source(h))), exact(mesh.point(mesh.target(h))));
  return result;
}

inline Part part_of(const Mesh_to_close& mesh, const std::vector<Face>& faces)
{
  Part part;
  std::map<Mesh_to_close::Vertex_index, Vertex> copies;
  for (const Face face : faces)
  {
    std::vector<Vertex> corners;
    for (const auto v : vertices_around_face(mesh.halfedge(face), mesh))
    {
      const auto [copy, is_new] = copies.emplace(v, Vertex());
      if (is_new)
        copy->second = part.add_vertex(exact(mesh.point(v)));
      corners.push_back(copy->second);
    }
    CGAL::Euler::add_face(corners, part);
  }
  Polygon_mesh_processing::duplicate_non_manifold_vertices(part);
  return part;
}

// The triangles of the smallest surface in a hole; none if one of their edges is there already, or there is none.
inline std::vector<std::array<Vertex, 3>> triangles_in(const Part& part, const std::vector<Vertex>& loop)
{
  std::vector<Exact_point> points;
  for (const Vertex v : loop)
    points.push_back(part.point(v));
  std::vector<CGAL::Triple<int, int, int>> found;
  Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(found));
  std::vector<std::array<Vertex, 3>> triangles;
  const auto is_side = [&](int a, int b)
  { return b == a + 1 || (a == 0 && std::size_t(b) + 1 == loop.size()); };
  for (const auto& [a, b, c] : found)
  {
    std::array<int, 3> corners = {a, b, c};
    std::sort(corners.begin(), corners.end()); // in the direction of the loop
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)})
      if (!is_side(corners[i], corners[j]) &&
          part.halfedge(loop[corners[i]], loop[corners[j]]).is_valid())
        return {};
    triangles.push_back({loop[corners[0]], loop[corners[1]], loop[corners[2]]});
  }
  return triangles.size() + 2 == loop.size() ? triangles : std::vector<std::array<Vertex, 3>>();
}

inline std::vector<Vertex> loop_of(const Part& part, Halfedge side)
{
  const auto loop = vertices_around_face(side, part);
  return std::vector<Vertex>(loop.begin(), loop.end());
}

// Splits a face around a vertex in the middle, which no other face has.
inline std::vector<Face> add_fan(Part& part, Halfedge side)
{
  const std::vector<Vertex> loop = loop_of(part, side);
  const Halfedge to_middle = CGAL::Euler::add_center_vertex(side, part);
  Vector sum = CGAL::NULL_VECTOR;
  for (const Vertex v : loop)
    sum += (part.point(v) - CGAL::ORIGIN) / double(loop.size());
  part.point(part.target(to_middle)) = CGAL::ORIGIN + sum;
  const auto fan = faces_around_target(to_middle, part);
  return std::vector<Face>(fan.begin(), fan.end());
}

// Seen along the normal, where CGAL triangulates polygons: it crashes where these are a line, or two corners are one.
inline bool has_area_and_sides(const Part& part, Halfedge first)
{
  const Exact_point& origin = part.point(part.source(first));
  Vector normal = CGAL::NULL_VECTOR;
  double longest = 0; // squared, as all here
  for (const Halfedge h : halfedges_around_face(first, part))
  {
    normal += CGAL::cross_product(part.point(part.source(h)) - origin,
                                  part.point(part.target(h)) - origin);
    longest = (std::max)(longest,
                         CGAL::squared_distance(part.point(part.source(h)), part.point(part.target(h))));
  }
  const auto has_length = [&](const Halfedge h)
  {
    const Vector side = part.point(part.target(h)) - part.point(part.source(h));
    return CGAL::cross_product(side, normal).squared_length() >
           no_width * longest * normal.squared_length();
  };
  const auto sides = halfedges_around_face(first, part);
  return normal.squared_length() > no_width * longest * longest &&
         std::all_of(sides.begin(), sides.end(), has_length);
}

// CGAL's triangulation leaves what has no normal as it is, but functions for holes take triangles alone.
inline void triangulate(Part& part)
{
  const std::vector<Face> faces(part.faces().begin(), part.faces().end());
  for (const Face face : faces)
  {
    const Halfedge side = part.halfedge(face);
    const auto number_of_corners = halfedges_around_face(side, part).size();
    const bool is_safe = number_of_corners <= 4 || has_area_and_sides(part, side);
    if (number_of_corners > 3 && !(is_safe && Polygon_mesh_processing::triangulate_face(face, part)))
      add_fan(part, side);
  }
}

// Fairing divides by areas: where faces are single points, it fails, or gives points that are no numbers or anywhere.
// The cap stays flat then.
inline void fair_if_possible(Part& part, const std::vector<Vertex>& vertices)
{
  std::vector<Exact_point> old_points;
  for (const Vertex v : vertices)
    old_points.push_back(part.point(v));
  const auto is_near = [&](const Vertex v) // what is no number is not
  { return (part.point(v) - CGAL::ORIGIN).squared_length() <= farthest_cap * farthest_cap; };
  if (!Polygon_mesh_processing::fair(part, vertices) ||
      !std::all_of(vertices.begin(), vertices.end(), is_near))
    for (std::size_t i = 0; i < vertices.size(); ++i)
      part.point(vertices[i]) = old_points[i];
}

// The steps of CGAL's triangulate_refine_and_fair_hole(), whose parameters differ from version to version.
inline void close_hole(Part& part, Halfedge hole)
{
  std::vector<Face> cap;
  for (const auto& triangle : triangles_in(part, loop_of(part, hole)))
    cap.push_back(CGAL::Euler::add_face(triangle, part));
  if (cap.empty())
  {
    CGAL::Euler::fill_hole(hole, part);
    cap = add_fan(part, hole);
  }
  std::vector<Face> new_faces;
  std::vector<Vertex> new_vertices;
  Polygon_mesh_processing::refine(part, cap, std::back_inserter(new_faces),
                                  std::back_inserter(new_vertices));
  fair_if_possible(part, new_vertices);
}

inline bool touches_border_of_mesh(const Part& part, Halfedge hole, const std::set<Edge>& border_of_mesh)
{
  for (const Halfedge h : halfedges_around_face(hole, part))
    if (border_of_mesh.count({part.point(part.source(h)), part.point(part.target(h))}) > 0)
      return true;
  return false;
}

inline std::vector<Point> points_of(const Part& part)
{
  std::vector<Point> points;
  for (const Vertex v : part.vertices())
    points.emplace_back(part.point(v).x(), part.point(v).y(), part.point(v).z());
  return points;
}

// Of the first vertices; those that came later stay.
inline void put_back(Part& part, const std::vector<Point>& points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    part.point(Vertex(Part::size_type(i))) = exact(points[i]);
}

// In a ball of radius 1 to 2, for the areas that fairing multiplies must neither vanish nor overflow, and with a width
// for triangles that have none, so that caps beside them are round, too. The points of the part come back as they were.
inline void triangulate_and_close(Part& part, const std::vector<Halfedge>& holes)
{
  const std::vector<Point> old_points = points_of(part);
  const Ball ball = bounding_ball(old_points);
  const Exact_point center(ball.center[0], ball.center[1], ball.center[2]);
  const double unit = std::ldexp(1., std::ilogb(ball.radius)); // a power of two changes no digit
  for (const Vertex v : part.vertices())
    part.point(v) = CGAL::ORIGIN + (part.point(v) - center) / unit;
  triangulate(part);
  const std::vector<Point> points_of_triangles = points_of(part);
  widen_flat_triangles(part);
  for (const Halfedge hole : holes)
    close_hole(part, hole);
  put_back(part, points_of_triangles);
  for (const Vertex v : part.vertices())
    part.point(v) = center + (part.point(v) - CGAL::ORIGIN) * unit;
  put_back(part, old_points);
}

inline Closed_segment<Point> to_segment(const Part& part)
{
  Closed_segment<Point> segment;
  segment.points = points_of(part);
  for (const Face face : part.faces())
  {
    segment.polygons.emplace_back();
    for (const Vertex v : vertices_around_face(part.halfedge(face), part))
      segment.polygons.back().push_back(std::size_t(v));
  }
  return segment;
}

// For each segment the triangles of its faces and of rounded caps, those of each segment apart. A hole that touches the border of
// the mesh stays open.
inline std::vector<Closed_segment<Point>> parts_with_faired_caps(
  const Mesh_to_close& mesh,
  const std::vector<std::size_t>& segment_of_face,
  std::size_t number_of_segments)
{
  std::vector<std::vector<Face>> faces_of(number_of_segments);
  for (const Face face : faces(mesh))
    faces_of[segment_of_face[face]].push_back(face);
  const std::set<Edge> border_of_mesh = border_edges(mesh);
  std::vector<Closed_segment<Point>> parts;
  for (const std::vector<Face>& faces : faces_of)
  {
    Part part = part_of(mesh, faces);
    std::vector<Halfedge> cycles, holes;
    Polygon_mesh_processing::extract_boundary_cycles(part, std::back_inserter(cycles));
    std::copy_if(cycles.begin(), cycles.end(), std::back_inserter(holes),
                 [&](const Halfedge cycle)
                 { return !touches_border_of_mesh(part, cycle, border_of_mesh); });
    triangulate_and_close(part, holes);
    parts.push_back(to_segment(part));
  }
  return parts;
}

} // namespace CGAL::Protrusion_segmentation::internal::faired_caps

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_PARTS_WITH_FAIRED_CAPS_H
