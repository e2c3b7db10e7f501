// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/Input_mesh.h"

#include "reading/Format_error.h"

#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/near_points.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Signed_volume.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/nested_components.h>
#include <CGAL/Protrusion_segmentation/polygon_soup_to_manifold_mesh.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tool {
namespace {

namespace internal = CGAL::Protrusion_segmentation::internal;

using Vertex = Mesh::Vertex_index;

// Adds faces to a mesh that has their vertices, `vertices[i]` for corner i. Returns whether all fit and every vertex has
// one fan of faces around it: a further fan would make a second gap at its vertex, or could not be added.
bool add_faces(const Polygons& faces, const std::vector<Vertex>& vertices, Mesh& mesh)
{
  std::vector<Vertex> corners;
  for (const Corners& face : faces)
  {
    corners.clear();
    for (const std::size_t corner : face)
      corners.push_back(vertices[corner]);
    if (CGAL::Euler::add_face(corners, mesh) == Mesh::null_face())
      return false;
  }
  std::vector<bool> has_gap(mesh.number_of_vertices(), false);
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
    {
      if (has_gap[mesh.target(h)])
        return false;
      has_gap[mesh.target(h)] = true;
    }
  return mesh.is_valid(false);
}

// Is there a face whose neighbours are all one face? Its double may be that.
bool may_have_double(const Mesh& mesh)
{
  return std::any_of(mesh.faces_begin(), mesh.faces_end(),
                     [&](Face face)
                     {
                       const auto first = mesh.halfedge(face);
                       const Face neighbor = mesh.face(mesh.opposite(first));
                       auto h = mesh.next(first);
                       while (h != first && mesh.face(mesh.opposite(h)) == neighbor)
                         h = mesh.next(h);
                       return h == first && neighbor != Mesh::null_face();
                     });
}

std::size_t number_of_components(const Mesh& mesh)
{
  internal::Disjoint_sets sets(mesh.number_of_faces());
  for (const auto edge : mesh.edges())
    if (!mesh.is_border(edge))
      sets.union_set(mesh.face(mesh.halfedge(edge, 0)), mesh.face(mesh.halfedge(edge, 1)));
  return std::size_t(std::count_if(mesh.faces_begin(), mesh.faces_end(),
                                   [&](Face face) { return sets.find_set(face) == face; }));
}

void add_used_points(Input_mesh& input, std::vector<Vertex>& vertices)
{
  const std::vector<Point>& points = input.soup.points;
  std::vector<bool> is_used(points.size(), false);
  for (const Corners& polygon : input.soup.polygons)
    for (const std::size_t corner : polygon)
      is_used[corner] = true;
  vertices.resize(points.size());
  for (std::size_t point = 0; point < points.size(); ++point)
    if (is_used[point])
    {
      vertices[point] = input.mesh.add_vertex(points[point]);
      input.point_of_vertex.push_back(point);
    }
}

void reserve(const Polygon_soup& soup, Mesh& mesh)
{
  using Size = Mesh::size_type;
  const std::size_t vertices = soup.points.size(), faces = soup.polygons.size();
  mesh.reserve(Size(vertices), Size(vertices + faces), Size(faces));
}

bool has_points_at_one_place(const std::vector<Point>& points)
{
  const std::vector<std::size_t> places = internal::places(points);
  for (std::size_t point = 0; point < places.size(); ++point)
    if (places[point] != point)
      return true;
  return false;
}

// Are there corners on borders that the search for repairs may join to others?
bool may_be_sewn(const Mesh& mesh, std::optional<double> tolerance)
{
  std::vector<std::array<std::size_t, 2>> sides;
  std::set<std::size_t> ends;
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
    {
      sides.push_back({std::size_t(mesh.source(h)), std::size_t(mesh.target(h))});
      ends.insert(sides.back().begin(), sides.back().end());
    }
  if (sides.empty())
    return false;
  std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  const int exponent = internal::scale_to_unit(points);
  const double scaled = tolerance ? std::ldexp(*tolerance, -exponent)
                                  : internal::automatic_tolerance(points);
  return scaled > 0 && !internal::near_points(points, sides, ends, scaled).empty();
}

// Builds the mesh of a file that needs no repair, as most do: then the faces as they are make up a surface, and what
// the search for repairs takes, several times as long as this, is saved. Returns whether it is one.
bool build_sound_mesh(Input_mesh& input, std::optional<double> tolerance)
{
  if (has_points_at_one_place(input.soup.points))
    return false;
  reserve(input.soup, input.mesh);
  std::vector<Vertex> vertices;
  add_used_points(input, vertices);
  if (!add_faces(input.soup.polygons, vertices, input.mesh) || may_have_double(input.mesh) ||
      may_be_sewn(input.mesh, tolerance))
  {
    input.mesh = Mesh();
    input.point_of_vertex.clear();
    return false;
  }
  input.label_giver.resize(input.soup.polygons.size());
  std::iota(input.label_giver.begin(), input.label_giver.end(), std::uint32_t(0));
  input.face_in_file = input.label_giver;
  input.repairs.components = number_of_components(input.mesh);
  return true;
}

// Of a mesh in one piece.
bool is_inside_out(const Mesh& mesh)
{
  if (!CGAL::is_closed(mesh))
    return false;
  std::vector<Point> points(mesh.points().begin(), mesh.points().end()), corners;
  internal::scale_to_unit(points);
  internal::Signed_volume volume;
  for (const Face face : mesh.faces())
  {
    corners.clear();
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
      corners.push_back(points[v]);
    volume.add(corners);
  }
  return volume.orientation() < 0;
}

// Turns over the closed components that are inside out, with the walls of their cavities. Returns their number.
std::size_t turn_outward(Mesh& mesh, std::size_t number_of_components)
{
  if (number_of_components == 1) // the most frequent ones, and the largest
  {
    const bool is_turned = is_inside_out(mesh);
    if (is_turned)
      CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
    return is_turned ? 1 : 0;
  }
  internal::Surface_arrays surface = internal::read_arrays(mesh, CGAL::parameters::default_values());
  internal::scale_to_unit(surface.points);
  const std::vector<internal::Surface_arrays::Index> components = internal::components_of_faces(surface);
  const std::size_t number = 1 + *std::max_element(components.begin(), components.end());
  const internal::Nested_components nested(surface, components, number);
  std::vector<Face> faces;
  std::size_t count = 0;
  for (std::uint32_t c = 0; c < number; ++c)
    if (nested.is_inside_out(c))
    {
      for (const std::uint32_t face : nested.faces(c))
        faces.emplace_back(face);
      ++count;
    }
  CGAL::Polygon_mesh_processing::reverse_face_orientations(faces, mesh);
  return count;
}

// Then a mesh is no surface, but loose faces.
bool hardly_any_faces_are_joined(const Input_mesh& input)
{
  constexpr std::size_t few_faces_of_component = 2, many_components = 10;
  return input.repairs.components > many_components &&
         input.mesh.number_of_faces() < few_faces_of_component * input.repairs.components;
}

std::string counted(std::size_t count, const std::string& one, const std::string& more)
{
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

auto make_mesh(const Polygon_soup& soup, Mesh& mesh, std::optional<double> tolerance)
{
  try
  {
    using CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh;
    return tolerance ? polygon_soup_to_manifold_mesh(soup.points, soup.polygons, mesh,
                                                     CGAL::parameters::snapping_tolerance(*tolerance))
                     : polygon_soup_to_manifold_mesh(soup.points, soup.polygons, mesh);
  }
  catch (
    const std::
      invalid_argument&) // whoever read the soup found all else, and named it in the words of the format
  {
    throw Format_error("has degenerate faces only: none has three different corners");
  }
}

} // namespace

Input_mesh make_input_mesh(Polygon_soup soup, std::optional<double> tolerance)
{
  Input_mesh input;
  input.soup = std::move(soup);
  if (!build_sound_mesh(input, tolerance))
  {
    auto result = make_mesh(input.soup, input.mesh, tolerance);
    input.label_giver.assign(result.face_of_polygon.begin(), result.face_of_polygon.end());
    input.face_in_file.assign(result.polygon_of_face.begin(), result.polygon_of_face.end());
    input.point_of_vertex = std::move(result.point_of_vertex);
    input.repairs = result.repairs;
  }
  input.inside_out_components = turn_outward(input.mesh, input.repairs.components);
  return input;
}

std::string describe_repairs(const Input_mesh& input)
{
  const Repairs& repairs = input.repairs;
  if (input.has_joined_pieces())
  {
    const std::set<std::size_t> pieces(input.pieces.begin(), input.pieces.end());
    return counted(pieces.size(), "piece is", "pieces are") + " joined to " +
           counted(repairs.components, "shape", "shapes");
  }
  std::vector<std::string> parts;
  if (repairs.degenerate_polygons > 0)
    parts.push_back(counted(repairs.degenerate_polygons, "degenerate face has", "degenerate faces have") +
                    " the label of a neighbour");
  if (repairs.duplicate_polygons > 0)
    parts.push_back(counted(repairs.duplicate_polygons, "duplicate face has", "duplicate faces have") +
                    " that of the first");
  if (repairs.joined_corners > 0)
    parts.push_back(counted(repairs.joined_corners, "corner was", "corners were") +
                    " joined to one that nearly agrees");
  if (repairs.split_edges > 0)
    parts.push_back(counted(repairs.split_edges, "corner was", "corners were") +
                    " joined to an edge that it lies on");
  if (repairs.non_manifold_edges > 0)
    parts.push_back(counted(repairs.non_manifold_edges, "edge is", "edges are") +
                    " of more than two faces");
  if (repairs.unorientable_edges > 0)
    parts.push_back("cut open at " + counted(repairs.unorientable_edges, "edge", "edges") +
                    ", since the surface has no two sides");
  if (repairs.reversed_polygons > 0)
    parts.push_back(counted(repairs.reversed_polygons, "face was", "faces were") + " turned over");
  if (repairs.small_components > 0)
    parts.push_back(counted(repairs.small_components, "small component has", "small components have") +
                    " the label of a neighbour");
  if (input.inside_out_components > 0)
    parts.push_back(counted(input.inside_out_components, "component is", "components are") +
                    " inside out, and treated as turned outward");
  if (!parts.empty())
    parts.push_back(counted(repairs.components, "component is", "components are") + " left");
  if (hardly_any_faces_are_joined(input))
    parts.push_back("hardly any faces share edges; --weld DISTANCE joins corners that nearly agree");
  std::string line;
  for (const std::string& part : parts)
    line += (line.empty() ? "" : "; ") + part;
  return line;
}

} // namespace tool
