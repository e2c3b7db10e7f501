// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/Input_mesh.h"

#include "repair/Edge_pairs.h"
#include "repair/Face_choice.h"
#include "repair/Joined_faces.h"
#include "repair/Parity_sets.h"
#include "repair/Specks.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace tool
{
namespace
{

using Vertex = Mesh::Vertex_index;

// Adds faces to a mesh that has their vertices, `vertices[i]` for corner i. Returns whether all fit and every vertex has
// one fan of faces around it: a further fan would make a second gap at its vertex, or could not be added.
bool add_faces(const std::vector<Polygon>& faces, const std::vector<Vertex>& vertices, Mesh& mesh)
{
  std::vector<Vertex> corners;
  for (const Polygon& face : faces)
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

void reserve(std::size_t number_of_vertices, std::size_t number_of_faces, Mesh& mesh)
{
  using Size = Mesh::size_type;
  mesh.reserve(Size(number_of_vertices), Size(number_of_vertices + number_of_faces), Size(number_of_faces));
}

void build_mesh(const Joined_faces& joined, Input_mesh& input)
{
  const std::vector<Polygon>& faces = joined.choice.polygons;
  std::vector<std::array<std::size_t, 3>> corners; // point, vertex, side
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (std::size_t i = 0; i < faces[face].size(); ++i)
    {
      const std::size_t side = joined.pairs.first_side(face) + i;
      corners.push_back({faces[face][i], joined.fans.vertex_at(side), side});
    }
  std::sort(corners.begin(), corners.end()); // the vertices are in the order of their points in the file

  std::vector<Vertex> vertex_at(corners.size(), Mesh::null_vertex());
  for (const auto& [point, vertex, side] : corners)
    if (vertex_at[vertex] == Mesh::null_vertex())
    {
      vertex_at[vertex] = input.mesh.add_vertex(input.soup.points[point]);
      input.point_of_vertex.push_back(point);
    }
  std::vector<Polygon> polygons;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    Polygon polygon(faces[face].size());
    for (std::size_t i = 0; i < polygon.size(); ++i)
      polygon[i] = joined.fans.vertex_at(joined.pairs.first_side(face) + i);
    if (joined.is_turned[face])
      std::reverse(polygon.begin() + 1, polygon.end());
    polygons.push_back(polygon);
  }
  if (!add_faces(polygons, vertex_at, input.mesh))
    throw std::logic_error("the faces do not make up a surface mesh");
}

std::size_t number_of_components(const Edge_pairs& pairs)
{
  const std::vector<std::size_t> component = pairs.components();
  std::size_t count = 0;
  for (std::size_t face = 0; face < component.size(); ++face)
    count += component[face] == face ? 1 : 0; // it is named after one of its faces
  return count;
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
  Parity_sets sets(mesh.number_of_faces());
  for (const auto edge : mesh.edges())
    if (!mesh.is_border(edge))
      sets.unite(mesh.face(mesh.halfedge(edge, 0)), mesh.face(mesh.halfedge(edge, 1)), false);
  std::size_t count = 0;
  for (const Face face : mesh.faces())
    count += sets.find(face).first == face ? 1 : 0;
  return count;
}

void add_used_points(Input_mesh& input, std::vector<Vertex>& vertices)
{
  const std::vector<Point>& points = input.soup.points;
  std::vector<bool> is_used(points.size(), false);
  for (const Polygon& polygon : input.soup.polygons)
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

// Builds the mesh of a file that needs no repair, as most do: then the faces as they are make up a surface, and what
// the search for repairs takes, several times as long as this, is saved. Returns whether it is one.
bool build_sound_mesh(const std::vector<std::size_t>& place_of, Input_mesh& input)
{
  for (std::size_t point = 0; point < place_of.size(); ++point)
    if (place_of[point] != point)
      return false;
  const std::size_t number_of_faces = input.soup.polygons.size();
  reserve(input.soup.points.size(), number_of_faces, input.mesh);
  std::vector<Vertex> vertices;
  add_used_points(input, vertices);
  if (!add_faces(input.soup.polygons, vertices, input.mesh) || may_have_double(input.mesh))
  {
    input.mesh = Mesh();
    input.point_of_vertex.clear();
    return false;
  }
  input.label_giver.resize(number_of_faces);
  std::iota(input.label_giver.begin(), input.label_giver.end(), std::size_t(0));
  input.face_in_file = input.label_giver;
  input.repairs.components = number_of_components(input.mesh);
  return true;
}

std::string counted(std::size_t count, const std::string& one, const std::string& more)
{
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

} // namespace

Input_mesh make_input_mesh(Polygon_soup soup)
{
  Input_mesh input;
  input.soup = std::move(soup);
  const std::vector<std::size_t> place_of = places(input.soup.points);
  if (build_sound_mesh(place_of, input))
    return input;
  std::vector<bool> is_left_out(input.soup.polygons.size(), false);
  auto joined = std::make_unique<Joined_faces>(input.soup, place_of, is_left_out);
  Repairs& repairs = input.repairs;
  repairs.degenerate_faces = joined->choice.degenerate_faces;
  repairs.duplicate_faces = joined->choice.duplicate_faces;
  repairs.non_manifold_edges = joined->pairs.number_of_non_manifold_edges();
  repairs.specks = Specks(input.soup, place_of, *joined).leave_out(is_left_out);
  if (repairs.specks > 0) // then the rest goes together anew
    joined = std::make_unique<Joined_faces>(input.soup, place_of, is_left_out);
  repairs.reversed_faces = std::size_t(std::count(joined->is_turned.begin(), joined->is_turned.end(), true));
  repairs.components = number_of_components(joined->pairs);
  build_mesh(*joined, input);
  input.label_giver = joined->choice.label_giver;
  input.face_in_file = joined->choice.kept;
  return input;
}

std::string describe(const Repairs& repairs)
{
  std::vector<std::string> parts;
  if (repairs.degenerate_faces > 0)
    parts.push_back(counted(repairs.degenerate_faces, "degenerate face has", "degenerate faces have") +
                    " the label of a neighbour");
  if (repairs.duplicate_faces > 0)
    parts.push_back(counted(repairs.duplicate_faces, "duplicate face has", "duplicate faces have") +
                    " that of the first");
  if (repairs.non_manifold_edges > 0)
    parts.push_back(counted(repairs.non_manifold_edges, "edge is", "edges are") + " of more than two faces");
  if (repairs.reversed_faces > 0)
    parts.push_back(counted(repairs.reversed_faces, "face was", "faces were") + " turned over");
  if (repairs.specks > 0)
    parts.push_back(counted(repairs.specks, "speck has", "specks have") + " the label of a neighbour");
  if (!parts.empty())
    parts.push_back(counted(repairs.components, "component is", "components are") + " left");
  std::string line;
  for (const std::string& part : parts)
    line += (line.empty() ? "" : "; ") + part;
  return line;
}

} // namespace tool
