// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"
#include "sphere.h"
#include "tables.h"

#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Point_3 = Mesh::Point;
using Vector_3 = CGAL::Kernel_traits<Point_3>::type::Vector_3;

constexpr double turn = 2 * CGAL_PI;
constexpr std::size_t number_of_segments = 7; // as animals mostly have

// What is at the place (u, v), both from 0 to 1.
using Parametrization = std::function<Point_3(double u, double v)>;

// A grid of m times n places, two triangles between four of them, closed in the direction of u and of v or not.
Mesh grid(std::size_t m, std::size_t n, bool closes_u, bool closes_v, const Parametrization& point_at)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      vertices.push_back(mesh.add_vertex(point_at(double(i) / double(m), double(j) / double(n))));
  const auto vertex = [&](std::size_t i, std::size_t j) { return vertices[i % m * n + j % n]; };
  for (std::size_t i = 0; i < (closes_u ? m : m - 1); ++i)
    for (std::size_t j = 0; j < (closes_v ? n : n - 1); ++j)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

double unit(const Vector_3&)
{
  return 1;
}

double with_bumps(const Vector_3& d)
{
  return 1 + 0.3 * std::sin(4 * d.x()) * std::cos(5 * d.y()) * std::sin(3 * d.z());
}

// `bulge`: by how much of its radius the tube of it is thicker and thinner, five times around.
Mesh torus(double bulge)
{
  return grid(1000, 500, true, true,
              [=](double u, double v)
              {
                const double tube = 0.7 * (1 + bulge * std::sin(5 * turn * u)), radius = 2 + tube * std::cos(turn * v);
                return Point_3(radius * std::cos(turn * u), radius * std::sin(turn * u), tube * std::sin(turn * v));
              });
}

Mesh tube()
{
  return grid(2500, 200, false, true,
              [](double u, double v)
              { return Point_3(25000 * u, 3 * std::cos(turn * v), 3 * std::sin(turn * v)); });
}

Mesh sheet(const std::function<double(double u, double v)>& height)
{
  return grid(710, 710, false, false, [&](double u, double v) { return Point_3(u, v, height(u, v)); });
}

// Triangles at one corner are a hundred thousand times as long as at the other.
Mesh graded_sheet()
{
  return grid(710, 710, false, false,
              [](double u, double v) { return Point_3(std::pow(1e5, u), std::pow(1e5, v), 0); });
}

Mesh spheres(std::size_t number)
{
  const Mesh one = sphere<Mesh>(1, unit);
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (std::size_t i = 0; i < number; ++i)
  {
    const Vector_3 shift(3. * double(i % 100), 3. * double(i / 100), 0);
    vertices.clear();
    for (const Mesh::Vertex_index v : one.vertices())
      vertices.push_back(mesh.add_vertex(one.point(v) + shift));
    for (const Mesh::Face_index f : one.faces())
    {
      std::vector<Mesh::Vertex_index> corners;
      for (const Mesh::Vertex_index v : vertices_around_face(one.halfedge(f), one))
        corners.push_back(vertices[v]);
      mesh.add_face(corners);
    }
  }
  return mesh;
}

std::vector<std::pair<std::string, std::function<Mesh()>>> shapes()
{
  return {{"sphere", [] { return sphere<Mesh>(8, unit); }},
          {"sphere with bumps", [] { return sphere<Mesh>(8, with_bumps); }},
          {"torus", [] { return torus(0); }},
          {"torus with bulges", [] { return torus(0.4); }},
          {"tube, a thousand times as long as its radius", tube},
          {"flat sheet", [] { return sheet([](double, double) { return 0; }); }},
          {"sheet with hills", [] { return sheet([](double u, double v) { return 0.03 * std::sin(18 * u) * std::cos(13 * v); }); }},
          {"sheet with triangles of all sizes", graded_sheet},
          {"20,000 spheres", [] { return spheres(20000); }}};
}

} // namespace

void print_shape_table(const Options& options, const Benchmark_folder&)
{
  std::cout << "## 7. Shapes without protrusions\n\nAbout a million faces, " << number_of_segments
            << " segments asked for. Goal: at most ten times the time for a face in table 3.\n\n";
  const std::vector<Segmentation_method> methods = methods_to_measure(options);
  std::vector<std::string> header = {"shape", "faces"};
  for (const Segmentation_method& method : methods)
    header.insert(header.end(), {method.name + " [s]", "[us / face]"});
  const Markdown_table table(header);
  for (const auto& [name, make] : shapes())
  {
    const Mesh mesh = make();
    const double n = double(mesh.number_of_faces());
    std::vector<std::string> cells = {name, number(n, 0)};
    for (const Segmentation_method& method : methods)
    {
      const double seconds = seconds_of(1, [&] { method.segment(mesh, number_of_segments, 0); });
      cells.insert(cells.end(), {number(seconds), number(1e6 * seconds / n)});
    }
    table.row(cells);
  }
}
