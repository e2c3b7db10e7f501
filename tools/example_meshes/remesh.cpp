// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The remeshing of M. Botsch and L. Kobbelt: A Remeshing Approach to Multiresolution Modeling, SGP 2004,
// section 4, without the splitting of long edges, which a fine mesh does not have.

#include "example_meshes/remesh.h"

#include "zero_set.h" // the mesher of the tests

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <utility>
#include <vector>

namespace example_shapes
{
namespace
{

using tool::Mesh;
using Halfedge = Mesh::Halfedge_index;
using Vertex = Mesh::Vertex_index;

double length(const Vector& v) { return std::sqrt(v.squared_length()); }

// As long as twice the area. CGAL::normal() does not allow for triangles without area, which look nowhere.
Vector normal_of(const Point& a, const Point& b, const Point& c) { return CGAL::cross_product(b - a, c - a); }

// Do two triangles look about the same way? `normal` has any length.
bool looks_along(const Vector& normal, const Point& a, const Point& b, const Point& c)
{
  const double least_cosine = 0.7;
  const Vector other = normal_of(a, b, c);
  return other * normal > least_cosine * length(other) * length(normal);
}

// If the target of `h` moved to `p`, would its edges be short enough and near the surface, which thin
// tips demand, and its faces that the collapse leaves look as before?
bool can_move_target(const Mesh& mesh, const Shape& shape, Halfedge h, const Point& p, double edge)
{
  const double longest = 4. / 3 * edge, farthest = 0.1 * edge;
  const Vertex source = mesh.source(h);
  for (const Halfedge to : CGAL::halfedges_around_target(h, mesh))
  {
    const Vertex other = mesh.source(to), third = mesh.target(mesh.next(to));
    if (length(p - mesh.point(other)) > longest ||
        std::abs(shape(CGAL::midpoint(p, mesh.point(other)))) > farthest)
      return false;
    const Point &a = mesh.point(other), &b = mesh.point(mesh.target(h)), &c = mesh.point(third);
    if (other != source && third != source && !looks_along(normal_of(a, b, c), a, p, c))
      return false;
  }
  return true;
}

void collapse_short_edges(Mesh& mesh, const Shape& shape, double edge)
{
  const double shortest = 4. / 5 * edge;
  const std::vector<Mesh::Edge_index> edges(mesh.edges().begin(), mesh.edges().end());
  for (const Mesh::Edge_index e : edges)
  {
    if (mesh.is_removed(e))
      continue;
    const Halfedge h = mesh.halfedge(e);
    const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h));
    const Point middle = CGAL::midpoint(p, q);
    if (length(q - p) < shortest && CGAL::Euler::does_satisfy_link_condition(e, mesh) &&
        can_move_target(mesh, shape, h, middle, edge) &&
        can_move_target(mesh, shape, mesh.opposite(h), middle, edge))
      mesh.point(CGAL::Euler::collapse_edge(e, mesh)) = middle;
  }
  mesh.collect_garbage();
}

// How far the four vertices around an edge are from having six neighbours each, if the edge is as it
// is, and if it is flipped.
std::pair<int, int> irregularity(const Mesh& mesh, Halfedge h)
{
  const auto excess = [&](Halfedge to) { return int(mesh.degree(mesh.target(to))) - 6; };
  const Halfedge o = mesh.opposite(h);
  const int ends[] = {excess(h), excess(o)};
  const int tips[] = {excess(mesh.next(h)), excess(mesh.next(o))};
  const auto square = [](int x) { return x * x; };
  return {square(ends[0]) + square(ends[1]) + square(tips[0]) + square(tips[1]),
          square(ends[0] - 1) + square(ends[1] - 1) + square(tips[0] + 1) + square(tips[1] + 1)};
}

// Would the two triangles look about the same way after the flip as before?
bool is_flat(const Mesh& mesh, Halfedge h)
{
  const Halfedge o = mesh.opposite(h);
  const Point &from = mesh.point(mesh.source(h)), &to = mesh.point(mesh.target(h));
  const Point &left = mesh.point(mesh.target(mesh.next(h)));
  const Point &right = mesh.point(mesh.target(mesh.next(o)));
  const Vector normal = normal_of(from, to, left) + normal_of(to, from, right);
  return looks_along(normal, from, right, left) && looks_along(normal, to, left, right);
}

// Triangles around a vertex can be equilateral if there are six.
void flip_edges(Mesh& mesh)
{
  for (const auto edge : mesh.edges())
  {
    const Halfedge h = mesh.halfedge(edge), o = mesh.opposite(h);
    const auto [before, after] = irregularity(mesh, h);
    const bool is_joined =
        mesh.halfedge(mesh.target(mesh.next(h)), mesh.target(mesh.next(o))) != Mesh::null_halfedge();
    if (after < before && !is_joined && is_flat(mesh, h))
      CGAL::Euler::flip_edge(h, mesh);
  }
}

// Moves each vertex along the surface towards the mean of its neighbours. Not straight to that: at the
// tip of an arm it is closer to the axis than to the surface.
void even_out(Mesh& mesh, const Shape& shape, double edge)
{
  const auto value = [&](const test_meshes::Point& p) { return shape(Point(p[0], p[1], p[2])); };
  const double step = 1e-3 * edge;
  std::vector<test_meshes::Point> moved(mesh.num_vertices());
  for (const auto v : mesh.vertices())
  {
    Vector sum = CGAL::NULL_VECTOR;
    for (const Halfedge h : CGAL::halfedges_around_target(v, mesh))
      sum = sum + (mesh.point(mesh.source(h)) - mesh.point(v));
    const Vector move = sum / double(mesh.degree(v));
    const test_meshes::Point p = {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
    const test_meshes::Point g = test_meshes::gradient(value, p, step);
    const Vector normal(g[0], g[1], g[2]);
    const Vector along = move - (move * normal / normal.squared_length()) * normal;
    const test_meshes::Point target = {p[0] + along.x(), p[1] + along.y(), p[2] + along.z()};
    moved[v] = test_meshes::projection(value, target, step);
  }
  for (const auto v : mesh.vertices())
    mesh.point(v) = Point(moved[v][0], moved[v][1], moved[v][2]);
}

} // namespace

void remesh(tool::Mesh& mesh, const Shape& shape, double edge)
{
  for (int round = 0; round < 6; ++round)
  {
    collapse_short_edges(mesh, shape, edge);
    flip_edges(mesh);
    even_out(mesh, shape, edge);
  }
}

} // namespace example_shapes
