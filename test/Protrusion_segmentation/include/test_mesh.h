// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A test mesh: an indexed polygon soup and the true part of every face, with its measures and its
// conversion into any mesh type of CGAL.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESH_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESH_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

using Point = std::array<double, 3>;
using Face = std::vector<std::size_t>;            // indices of points, counterclockwise seen from outside
using Edge = std::pair<std::size_t, std::size_t>; // from a point to the next one of a face

constexpr double pi = 3.14159265358979323846;

struct Test_mesh
{
  std::vector<Point> points;
  std::vector<Face> faces;
  std::vector<std::size_t> parts; // of every face its true part: 0 .. number of parts - 1

  std::size_t add_point(const Point& point)
  {
    points.push_back(point);
    return points.size() - 1;
  }

  void add_face(Face face, std::size_t part = 0)
  {
    faces.push_back(std::move(face));
    parts.push_back(part);
  }
};

inline Point operator+(const Point& p, const Point& q)
{
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}

inline Point operator-(const Point& p, const Point& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

inline Point operator*(double factor, const Point& p)
{
  return {factor * p[0], factor * p[1], factor * p[2]};
}

inline double dot(const Point& p, const Point& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

inline Point cross(const Point& p, const Point& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

inline double length(const Point& p)
{
  return std::sqrt(dot(p, p));
}

// The mean of the face's vertices.
inline Point centroid(const Test_mesh& mesh, const Face& face)
{
  Point sum = {0, 0, 0};
  for (std::size_t v : face)
    sum = sum + mesh.points[v];
  return (1. / static_cast<double>(face.size())) * sum;
}

// The normal of a face, as long as twice its area (exact for plane polygons, convex or not).
inline Point area_vector(const Test_mesh& mesh, const Face& face)
{
  Point sum = {0, 0, 0};
  const Point& origin = mesh.points[face[0]];
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
    sum = sum + cross(mesh.points[face[i]] - origin, mesh.points[face[i + 1]] - origin);
  return sum;
}

inline double face_area(const Test_mesh& mesh, const Face& face)
{
  return length(area_vector(mesh, face)) / 2;
}

inline double area(const Test_mesh& mesh)
{
  double sum = 0;
  for (const Face& face : mesh.faces)
    sum += face_area(mesh, face);
  return sum;
}

inline double area_of_part(const Test_mesh& mesh, std::size_t part)
{
  double sum = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (mesh.parts[f] == part)
      sum += face_area(mesh, mesh.faces[f]);
  return sum;
}

// Positive for a closed mesh that is oriented outward; exact for plane faces.
inline double volume(const Test_mesh& mesh)
{
  double sum = 0;
  for (const Face& face : mesh.faces)
    sum += dot(mesh.points[face[0]], area_vector(mesh, face)) / 6;
  return sum;
}

inline std::size_t number_of_parts(const Test_mesh& mesh)
{
  return mesh.parts.empty() ? 0 : 1 + *std::max_element(mesh.parts.begin(), mesh.parts.end());
}

// Of every directed edge, from one point of a face to the next, the faces that have it.
inline std::map<Edge, std::vector<std::size_t>> faces_of_edges(const Test_mesh& mesh)
{
  std::map<Edge, std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const Face& face = mesh.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i)
      faces[{face[i], face[(i + 1) % face.size()]}].push_back(f);
  }
  return faces;
}

// Edges without a face on their other side: 0 for a closed, consistently oriented mesh.
inline std::size_t number_of_border_edges(const Test_mesh& mesh)
{
  const auto faces = faces_of_edges(mesh);
  return static_cast<std::size_t>(
    std::count_if(faces.begin(), faces.end(),
                  [&](const auto& item) {
                    return faces.count({item.first.second, item.first.first}) == 0;
                  }));
}

// Vertices that some face uses, less edges, plus faces.
inline long euler_characteristic(const Test_mesh& mesh)
{
  std::set<std::size_t> vertices;
  std::set<Edge> edges;
  for (const auto& item : faces_of_edges(mesh))
  {
    vertices.insert(item.first.first);
    edges.insert(std::minmax(item.first.first, item.first.second));
  }
  return static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(mesh.faces.size());
}

// The number of connected pieces, where faces of the same part are connected over common edges.
inline std::size_t number_of_pieces(const Test_mesh& mesh, const std::vector<std::size_t>& parts)
{
  std::vector<std::size_t> parent(mesh.faces.size());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&](std::size_t f)
  {
    while (parent[f] != f)
      f = parent[f] = parent[parent[f]];
    return f;
  };
  std::size_t number = mesh.faces.size();

  std::map<Edge, std::size_t> face_of_edge;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const Face& face = mesh.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const Edge edge = std::minmax(face[i], face[(i + 1) % face.size()]);
      const std::size_t g = face_of_edge.emplace(edge, f).first->second;
      if (parts[f] == parts[g] && root(f) != root(g))
      {
        parent[root(f)] = root(g);
        --number;
      }
    }
  }
  return number;
}

inline std::size_t number_of_components(const Test_mesh& mesh)
{
  return number_of_pieces(mesh, std::vector<std::size_t>(mesh.faces.size(), 0));
}

// Adds `mesh` to `graph`, any model of MutableFaceGraph with an internal vertex-point map: adds
// `mesh.points` as vertices and `mesh.faces` as faces one by one in their order, so that in a new
// graph the i-th vertex is point i and the i-th face is face i (`part_of_face_map()` needs that).
// Throws std::runtime_error if the graph cannot hold the mesh, as for a Moebius strip.
template <typename FaceGraph>
void convert(const Test_mesh& mesh, FaceGraph& graph)
{
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  auto points = get(CGAL::vertex_point, graph);
  using Graph_point = typename boost::property_traits<decltype(points)>::value_type;

  std::vector<Vertex> vertices;
  for (const Point& p : mesh.points)
  {
    vertices.push_back(add_vertex(graph));
    put(points, vertices.back(), Graph_point(p[0], p[1], p[2]));
  }

  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    std::vector<Vertex> face;
    for (std::size_t v : mesh.faces[f])
      face.push_back(vertices.at(v));
    if (CGAL::Euler::add_face(face, graph) == boost::graph_traits<FaceGraph>::null_face())
      throw std::runtime_error("the mesh type cannot hold face " + std::to_string(f));
  }
}

// `convert()` into a new graph: `const auto sm = to_graph<CGAL::Surface_mesh<Point_3>>(star(5));`
template <typename FaceGraph>
FaceGraph to_graph(const Test_mesh& mesh)
{
  FaceGraph graph;
  convert(mesh, graph);
  return graph;
}

// The true part of every face of a graph that `to_graph()` made.
template <typename FaceGraph>
std::map<typename boost::graph_traits<FaceGraph>::face_descriptor, std::size_t> part_of_face_map(
  const Test_mesh& mesh,
  const FaceGraph& graph)
{
  std::map<typename boost::graph_traits<FaceGraph>::face_descriptor, std::size_t> result;
  std::size_t f = 0;
  for (auto face : faces(graph))
    result[face] = mesh.parts.at(f++);
  return result;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESH_H
