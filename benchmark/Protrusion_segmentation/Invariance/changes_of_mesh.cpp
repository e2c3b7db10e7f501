// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "changes_of_mesh.h"
#include "Face_distance_graph.h"
#include "other_triangles.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMS = CGAL::Surface_mesh_simplification;

// Adds the faces of `mesh`, with points moved by `move`, in the order of `faces`.
template <typename Move>
void add_copy(const Mesh& mesh, const std::vector<Face>& faces, std::size_t copy, Move move, Changed_mesh& result)
{
  std::map<Vertex, Vertex> vertices;
  for (const Face f : faces)
  {
    std::vector<Vertex> corners;
    for (const Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
    {
      const auto [found, is_new] = vertices.emplace(v, Vertex());
      if (is_new)
        found->second = result.mesh.add_vertex(move(mesh.point(v)));
      corners.push_back(found->second);
    }
    result.mesh.add_face(corners);
    result.origins.push_back(f);
    result.copies.push_back(copy);
  }
}

std::vector<Face> faces_in_order(const Mesh& mesh)
{
  return {mesh.faces().begin(), mesh.faces().end()};
}

Changed_mesh with_faces(const Mesh& mesh, const std::vector<Face>& faces)
{
  Changed_mesh result;
  add_copy(mesh, faces, 0, [](const Point& p) { return p; }, result);
  return result;
}

template <typename Move>
Changed_mesh moved(const Mesh& mesh, Move move)
{
  Changed_mesh result;
  add_copy(mesh, faces_in_order(mesh), 0, move, result);
  return result;
}

double size_of(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return std::sqrt(CGAL::squared_distance(Point(box.xmin(), box.ymin(), box.zmin()),
                                          Point(box.xmax(), box.ymax(), box.zmax())));
}

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for (const auto e : mesh.edges())
    sum += PMP::edge_length(mesh.halfedge(e), mesh);
  return sum / double(mesh.number_of_edges());
}

// Every coordinate of every vertex moves by up to `distance`.
Changed_mesh jittered(const Mesh& mesh, double distance)
{
  std::mt19937 generator(1);
  std::vector<Vector> steps(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  const auto step = [&]() { return distance * (double(generator()) / double((generator.max)()) * 2 - 1); };
  Mesh other = mesh;
  for (const Vertex v : other.vertices())
  {
    const double x = step(), y = step(), z = step();
    other.point(v) += Vector(x, y, z);
  }
  return with_faces(other, faces_in_order(other));
}

Changed_mesh permuted(const Mesh& mesh)
{
  std::vector<Face> order = faces_in_order(mesh);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  return with_faces(mesh, order);
}

Changed_mesh inside_out(const Mesh& mesh)
{
  Mesh other = mesh;
  PMP::reverse_face_orientations(other);
  return with_faces(other, faces_in_order(other));
}

Changed_mesh mirrored(const Mesh& mesh)
{
  Mesh other = mesh;
  for (const Vertex v : other.vertices())
    other.point(v) = Point(-mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  return inside_out(other);
}

Changed_mesh split_at_midpoints(const Changed_mesh& input)
{
  const Mesh& mesh = input.mesh;
  Changed_mesh result;
  std::vector<Vertex> midpoint(mesh.number_of_edges());
  for (const Vertex v : mesh.vertices())
    result.mesh.add_vertex(mesh.point(v)); // has the same number
  for (const auto e : mesh.edges())
    midpoint[e] = result.mesh.add_vertex(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  for (const Face f : mesh.faces())
  {
    std::vector<Vertex> centre;
    for (const auto h : halfedges_around_face(mesh.halfedge(f), mesh))
    {
      centre.push_back(midpoint[mesh.edge(h)]);
      result.mesh.add_face(midpoint[mesh.edge(h)], mesh.target(h), midpoint[mesh.edge(mesh.next(h))]);
    }
    result.mesh.add_face(centre);
    for (std::size_t i = 0; i <= centre.size(); ++i)
    {
      result.origins.push_back(input.origins[f]);
      result.copies.push_back(input.copies[f]);
    }
  }
  return result;
}

// Faces of another mesh come from the nearest face.
Changed_mesh with_nearest_origins(Mesh other, const Mesh& mesh)
{
  Changed_mesh result;
  for (const Face f : nearest_faces(other, mesh))
    result.origins.push_back(f);
  result.copies.resize(result.origins.size(), 0);
  result.mesh = std::move(other);
  return result;
}

Changed_mesh decimated(const Mesh& mesh, double share)
{
  Mesh other = mesh;
  SMS::edge_collapse(other, [share](double, const auto&, std::size_t initial, std::size_t current)
                     { return double(current) < share * double(initial); });
  other.collect_garbage();
  return with_nearest_origins(std::move(other), mesh);
}

Changed_mesh three_copies(const Mesh& mesh)
{
  const double distance = 2 * size_of(mesh);
  Changed_mesh result;
  for (std::size_t copy = 0; copy < 3; ++copy)
    add_copy(mesh, faces_in_order(mesh), copy,
             [&](const Point& p) { return p + double(copy) * Vector(distance, 0, 0); }, result);
  return result;
}

// A square of twenty by twenty quads below the mesh, three times its size.
Changed_mesh on_a_floor(const Mesh& mesh)
{
  constexpr std::size_t quads = 20;
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double side = 3 * size_of(mesh);
  Changed_mesh result = with_faces(mesh, faces_in_order(mesh));
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i <= quads; ++i)
    for (std::size_t j = 0; j <= quads; ++j)
      vertices.push_back(result.mesh.add_vertex(Point(box.xmin() + side * (double(i) / quads - 0.5),
                                                      box.ymin() + side * (double(j) / quads - 0.5),
                                                      box.zmin() - 0.01 * side)));
  const auto vertex = [&](std::size_t i, std::size_t j) { return vertices[i * (quads + 1) + j]; };
  for (std::size_t i = 0; i < quads; ++i)
    for (std::size_t j = 0; j < quads; ++j)
    {
      result.mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      result.mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  result.origins.resize(result.mesh.number_of_faces(), no_origin);
  result.copies.resize(result.mesh.number_of_faces(), 0);
  return result;
}

Changed_mesh without_a_face(const Mesh& mesh)
{
  std::vector<Face> order = faces_in_order(mesh);
  order.erase(order.begin() + std::ptrdiff_t(order.size() / 2));
  return with_faces(mesh, order);
}

// The faces for whose centroids a predicate holds.
template <typename Predicate>
Changed_mesh part_with(const Mesh& mesh, Predicate predicate)
{
  std::vector<Face> faces;
  for (const Face f : mesh.faces())
    if (predicate(face_centroid(mesh, f)))
      faces.push_back(f);
  return with_faces(mesh, faces);
}

// Without the lowest twentieth of the height.
Changed_mesh without_underside(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double least = box.zmin() + 0.05 * box.z_span();
  return part_with(mesh, [least](const Point& p) { return p.z() > least; });
}

// The half that is seen along the shortest side of the bounding box.
Changed_mesh one_side(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double spans[] = {box.x_span(), box.y_span(), box.z_span()};
  const int axis = int(std::min_element(spans, spans + 3) - spans);
  const double middle = ((box.min)(axis) + (box.max)(axis)) / 2;
  return part_with(mesh, [axis, middle](const Point& p) { return p[axis] > middle; });
}

// Both ends of the bounding box in x rise by a tenth of the size.
Changed_mesh bent(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double middle = (box.xmin() + box.xmax()) / 2, half = box.x_span() / 2, height = 0.1 * size_of(mesh);
  return moved(mesh, [=](const Point& p)
               { return p + Vector(0, 0, half > 0 ? height * CGAL::square((p.x() - middle) / half) : 0); });
}

// Edges collapse as long as that changes the shape by no more than rounding: few, long triangles are left of flat regions.
Changed_mesh with_long_triangles(const Mesh& mesh)
{
  const double volume = 1e-9 * std::pow(size_of(mesh), 3);
  Mesh other = mesh;
  SMS::edge_collapse(other, [most = volume * volume](double cost, const auto&, std::size_t, std::size_t) { return cost > most; });
  other.collect_garbage();
  return with_nearest_origins(std::move(other), mesh);
}

Point rotated(const Point& p)
{
  constexpr double c = 0.8, s = 0.6; // a rotation about z, then one about x
  const double x = c * p.x() - s * p.y(), y = s * p.x() + c * p.y();
  return Point(x, c * y - s * p.z(), s * y + c * p.z());
}

Change_of_mesh scaled(const std::string& name, double factor)
{
  return {name, "0", [factor](const Mesh& mesh)
          { return moved(mesh, [factor](const Point& p) { return CGAL::ORIGIN + factor * (p - CGAL::ORIGIN); }); }};
}

} // namespace

std::vector<Change_of_mesh> all_changes_of_mesh()
{
  const auto split = [](const Mesh& mesh) { return split_at_midpoints(with_faces(mesh, faces_in_order(mesh))); };
  return {{"faces and vertices permuted", "0", permuted},
          {"rotated", "0", [](const Mesh& mesh) { return moved(mesh, rotated); }},
          {"mirrored", "0", mirrored},
          scaled("a thousandth of the size", 1e-3),
          scaled("a thousand times the size", 1e3),
          {"three copies", "0", three_copies, [](std::size_t n) { return 3 * n; }},
          {"on a floor", "0", on_a_floor, [](std::size_t n) { return n + 1; }},
          {"turned inside out", ".03", inside_out},
          {"bent by a tenth", ".03", bent},
          {"without underside", ".03", without_underside},
          {"one side only", ".03", one_side},
          {"flat regions of long triangles", ".03", with_long_triangles},
          {"without one face", "-", without_a_face},
          {"vertices moved by 1 % of an edge", ".015", [](const Mesh& mesh) { return jittered(mesh, 0.01 * mean_edge_length(mesh)); }},
          {"noise of 0.1 % of the size", "-", [](const Mesh& mesh) { return jittered(mesh, 0.001 * size_of(mesh)); }},
          {"split at midpoints", ".03", split},
          {"split twice", ".03", [split](const Mesh& mesh) { return split_at_midpoints(split(mesh)); }},
          {"decimated to a half", ".04", [](const Mesh& mesh) { return decimated(mesh, 0.5); }},
          {"decimated to a quarter", "-", [](const Mesh& mesh) { return decimated(mesh, 0.25); }},
          {"remeshed, same number of faces", "-",
           [](const Mesh& mesh) { return with_nearest_origins(remeshed(mesh, 1, 1), mesh); }}};
}
