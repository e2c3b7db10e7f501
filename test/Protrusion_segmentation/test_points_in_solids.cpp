// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which points are inside a closed surface, compared with CGAL's answer, also for points above vertices and edges.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Surface/Solid.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Solid;
using internal::Surface_arrays;
using Point_3 = Indexed_surface::Point_3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

std::vector<CGAL::Bounded_side> sides(const Test_mesh& mesh, const std::vector<Point_3>& points)
{
  Surface_arrays arrays;
  for (const Point& p : mesh.points)
    arrays.points.emplace_back(p[0], p[1], p[2]);
  for (const Face& face : mesh.faces)
  {
    for (const std::size_t v : face)
      arrays.corner_vertices.push_back(static_cast<Surface_arrays::Index>(v));
    arrays.corner_begin.push_back(static_cast<Surface_arrays::Index>(arrays.corner_vertices.size()));
  }
  std::vector<Surface_arrays::Index> faces(mesh.faces.size());
  std::iota(faces.begin(), faces.end(), Surface_arrays::Index(0));
  return Solid(arrays, faces).sides(points);
}

void check_sides(const Test_mesh& mesh, const std::vector<Point_3>& points)
{
  const auto graph = to_graph<CGAL::Surface_mesh<Kernel::Point_3>>(triangulated(mesh));
  const CGAL::Side_of_triangle_mesh<CGAL::Surface_mesh<Kernel::Point_3>, Kernel> expected(graph);
  const std::vector<CGAL::Bounded_side> found = sides(mesh, points);
  for (std::size_t i = 0; i < points.size(); ++i)
    CGAL_CHECK_EQUAL(int(found[i]), int(expected(Kernel::Point_3(points[i].x(), points[i].y(), points[i].z()))));
}

// Corners, middles of edges and of faces, and what is above, below and beside them.
std::vector<Point_3> halves_of(int size)
{
  std::vector<Point_3> points;
  for (int x = -1; x <= 2 * size + 1; ++x)
    for (int y = -1; y <= 2 * size + 1; ++y)
      for (int z = -1; z <= 2 * size + 1; ++z)
        points.emplace_back(x / 2., y / 2., z / 2.);
  return points;
}

void cubes_are_exact()
{
  for (std::uint_fast32_t seed = 0; seed < 20; ++seed)
  {
    // a tower in each place of a square, none of which touches another one along an edge alone
    std::mt19937 random(seed);
    Cubes cubes;
    add_cubes(cubes, {0, 0, 0}, {4, 4, 1});
    for (int x = 0; x < 4; ++x)
      add_cubes(cubes, {x, 0, 1}, {x + 1, 1 + int(random() % 4), 1 + int(random() % 3)});
    check_sides(voxels(cubes), halves_of(4));
    check_sides(with_reversed_orientation(voxels(cubes)), halves_of(4));
  }
}

void random_points_of_bodies()
{
  for (const Test_mesh& mesh : {icosphere(2), star(5, 2, 0.25, 0.1, 0.2), merged({icosphere(2), with_reversed_orientation(scaled(icosphere(2), .5))}), football()})
  {
    std::mt19937 random(1);
    std::vector<Point_3> points;
    for (int i = 0; i < 2000; ++i)
    {
      const auto coordinate = [&] { return (double(random() % 2001) - 1000) / 700; };
      points.emplace_back(coordinate(), coordinate(), coordinate());
    }
    for (const Point& p : mesh.points) // on the surface, below it and above it
      for (const double z : {p[2], p[2] - .25, p[2] + .25})
        points.emplace_back(p[0], p[1], z);
    check_sides(mesh, points);
  }
}

int main()
{
  cubes_are_exact();
  random_points_of_bodies();
  return check::result();
}
