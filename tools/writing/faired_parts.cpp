// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/faired_parts.h"

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
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace tool
{
namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;

using Exact_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Part = CGAL::Surface_mesh<Exact_point>; // CGAL's functions for holes want exact predicates
using Vertex = Part::Vertex_index;
using Halfedge = Part::Halfedge_index;
using Edge = std::pair<Exact_point, Exact_point>;

Exact_point exact(const Point& point) { return Exact_point(point.x(), point.y(), point.z()); }

// Of the mesh, in the direction of the halfedges without a face.
std::set<Edge> border_edges(const Mesh& mesh)
{
  std::set<Edge> result;
  for (const auto h : halfedges(mesh))
    if (mesh.is_border(h))
      result.emplace(exact(mesh.point(mesh.source(h))), exact(mesh.point(mesh.target(h))));
  return result;
}

Part part_of(const Mesh& mesh, const std::vector<Face>& faces)
{
  Part part;
  std::map<Mesh::Vertex_index, Vertex> copies;
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
  PMP::duplicate_non_manifold_vertices(part);
  PMP::triangulate_faces(part);
  return part;
}

// The triangles of the smallest surface in a hole; none if one of their edges is there already, or there is none.
std::vector<std::array<Vertex, 3>> triangles_in(const Part& part, const std::vector<Vertex>& loop)
{
  std::vector<Exact_point> points;
  for (const Vertex v : loop)
    points.push_back(part.point(v));
  std::vector<CGAL::Triple<int, int, int>> found;
  PMP::triangulate_hole_polyline(points, std::back_inserter(found));
  std::vector<std::array<Vertex, 3>> triangles;
  const auto is_side = [&](int a, int b) { return b == a + 1 || (a == 0 && std::size_t(b) + 1 == loop.size()); };
  for (const auto& [a, b, c] : found)
  {
    std::array<int, 3> corners = {a, b, c};
    std::sort(corners.begin(), corners.end()); // in the direction of the loop
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)})
      if (!is_side(corners[i], corners[j]) && part.halfedge(loop[corners[i]], loop[corners[j]]).is_valid())
        return {};
    triangles.push_back({loop[corners[0]], loop[corners[1]], loop[corners[2]]});
  }
  return triangles.size() + 2 == loop.size() ? triangles : std::vector<std::array<Vertex, 3>>();
}

// Around a vertex in the middle, which no other face has.
std::vector<Face> add_fan(Part& part, Halfedge hole, const std::vector<Vertex>& loop)
{
  CGAL::Euler::fill_hole(hole, part);
  const Halfedge to_middle = CGAL::Euler::add_center_vertex(hole, part);
  double x = 0, y = 0, z = 0;
  for (const Vertex v : loop)
  {
    x += part.point(v).x() / double(loop.size());
    y += part.point(v).y() / double(loop.size());
    z += part.point(v).z() / double(loop.size());
  }
  part.point(part.target(to_middle)) = Exact_point(x, y, z);
  std::vector<Face> cap;
  for (const Face face : faces_around_target(to_middle, part))
    cap.push_back(face);
  return cap;
}

// The steps of CGAL's triangulate_refine_and_fair_hole(), whose parameters differ from version to version.
void close_hole(Part& part, Halfedge hole)
{
  std::vector<Vertex> loop;
  for (const Vertex v : vertices_around_face(hole, part))
    loop.push_back(v);
  std::vector<Face> cap;
  for (const auto& triangle : triangles_in(part, loop))
    cap.push_back(CGAL::Euler::add_face(triangle, part));
  if (cap.empty())
    cap = add_fan(part, hole, loop);
  std::vector<Face> new_faces;
  std::vector<Vertex> new_vertices;
  PMP::refine(part, cap, std::back_inserter(new_faces), std::back_inserter(new_vertices));
  PMP::fair(part, new_vertices);
}

bool touches_border_of_mesh(const Part& part, Halfedge hole, const std::set<Edge>& border_of_mesh)
{
  for (const Halfedge h : halfedges_around_face(hole, part))
    if (border_of_mesh.count({part.point(part.source(h)), part.point(part.target(h))}) > 0)
      return true;
  return false;
}

Polygon_soup to_soup(const Part& part)
{
  Polygon_soup soup;
  for (const Vertex v : part.vertices())
    soup.points.emplace_back(part.point(v).x(), part.point(v).y(), part.point(v).z());
  for (const Face face : part.faces())
  {
    soup.polygons.emplace_back();
    for (const Vertex v : vertices_around_face(part.halfedge(face), part))
      soup.polygons.back().push_back(std::size_t(v));
  }
  return soup;
}

} // namespace

std::vector<Polygon_soup> faired_parts(const Mesh& mesh,
                                      const std::vector<std::size_t>& segment_of_face,
                                      std::size_t number_of_segments)
{
  std::vector<std::vector<Face>> faces_of(number_of_segments);
  for (const Face face : faces(mesh))
    faces_of[segment_of_face[face]].push_back(face);
  const std::set<Edge> border_of_mesh = border_edges(mesh);
  std::vector<Polygon_soup> parts;
  for (const std::vector<Face>& faces : faces_of)
  {
    Part part = part_of(mesh, faces);
    std::vector<Halfedge> holes;
    PMP::extract_boundary_cycles(part, std::back_inserter(holes));
    for (const Halfedge hole : holes)
      if (!touches_border_of_mesh(part, hole, border_of_mesh))
        close_hole(part, hole);
    parts.push_back(to_soup(part));
  }
  return parts;
}

} // namespace tool
