// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed solids that touch each other are surfaces of their own, however their points are shared.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/polygon_soup_to_manifold_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

using namespace test_meshes;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Repairs = CGAL::Protrusion_segmentation::Polygon_soup_repairs;

// What polygons become: their repairs, and the components as meshes.
struct Found
{
  Repairs repairs;
  std::vector<Test_mesh> components;
};

Found repaired(const Test_mesh& soup)
{
  std::vector<Point_3> points;
  for (const Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  Mesh mesh;
  const auto found = CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh(points, soup.faces,
                                                                                  mesh);
  Test_mesh whole;
  for (const auto v : mesh.vertices())
    whole.add_point({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  Found result = {found.repairs, {}};
  std::vector<Mesh::Face_index> todo;
  std::vector<bool> is_seen(mesh.number_of_faces(), false);
  for (const auto seed : mesh.faces())
  {
    if (is_seen[seed])
      continue;
    result.components.push_back(whole);
    todo.assign(1, seed);
    is_seen[seed] = true;
    while (!todo.empty())
    {
      const auto f = todo.back();
      todo.pop_back();
      Face face;
      for (const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      {
        face.push_back(std::size_t(source(h, mesh)));
        const auto g = mesh.face(opposite(h, mesh));
        if (g == Mesh::null_face() || is_seen[g])
          continue;
        is_seen[g] = true;
        todo.push_back(g);
      }
      result.components.back().add_face(face);
    }
  }
  return result;
}

// Every point once.
Test_mesh with_shared_points(const Test_mesh& mesh)
{
  std::map<Point, std::size_t> numbers;
  Test_mesh result;
  for (const Face& face : mesh.faces)
  {
    Face shared;
    for (const std::size_t v : face)
    {
      const auto [number, is_new] = numbers.emplace(mesh.points[v], result.points.size());
      if (is_new)
        result.add_point(mesh.points[v]);
      shared.push_back(number->second);
    }
    result.add_face(shared);
  }
  return result;
}

std::vector<Test_mesh> with_all_kinds_of_points(const Test_mesh& mesh)
{
  return {mesh, exploded(mesh), with_shared_points(mesh)};
}

Test_mesh stack(int nx, int ny, int nz)
{
  std::vector<Test_mesh> cubes;
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z)
        cubes.push_back(translated(triangulated(box()), {1. * x, 1. * y, 1. * z}));
  return merged(cubes);
}

void check_solids(const Test_mesh& soup, std::vector<double> volumes, double tolerance = 1e-6)
{
  const Found found = repaired(soup);
  CGAL_CHECK_EQUAL(found.repairs.duplicate_polygons, 0);
  CGAL_CHECK_EQUAL(found.repairs.components, volumes.size());
  CGAL_CHECK_EQUAL(found.components.size(), volumes.size());
  std::sort(volumes.begin(), volumes.end());
  std::vector<double> of_found;
  for (const Test_mesh& component : found.components)
  {
    CGAL_CHECK_EQUAL(number_of_border_edges(component), 0);
    of_found.push_back(volume(component));
  }
  std::sort(of_found.begin(), of_found.end());
  for (std::size_t i = 0; i < (std::min)(volumes.size(), of_found.size()); ++i)
    CGAL_CHECK_CLOSE(of_found[i], volumes[i], tolerance);
}

void cubes_of_a_stack_are_solids()
{
  for (const std::array<int, 3>& n :
       {std::array<int, 3>{2, 1, 1}, {3, 1, 1}, {2, 2, 1}, {2, 2, 2}, {4, 3, 5}, {10, 10, 10}})
    for (const Test_mesh& soup : with_all_kinds_of_points(stack(n[0], n[1], n[2])))
    {
      const std::size_t number = std::size_t(n[0] * n[1] * n[2]);
      check_solids(soup, std::vector<double>(number, 1));
      check_solids(with_face_order(soup, random_permutation(soup.faces.size(), number)),
                   std::vector<double>(number, 1));
    }
}

void solids_may_be_turned_inside_out()
{
  for (const Test_mesh& soup : with_all_kinds_of_points(with_reversed_orientation(stack(2, 2, 2))))
    check_solids(soup, std::vector<double>(8, -1));
}

void solids_may_be_anywhere()
{
  for (const double angle : {.3, 1.1, 2.5})
  {
    const Test_mesh turned = translated(rotated(with_shared_points(stack(3, 2, 2)), {1, 2, 3}, angle),
                                        {100, -50, 3});
    check_solids(turned, std::vector<double>(12, 1));
    check_solids(exploded(turned), std::vector<double>(12, 1));
  }
}

void solids_may_touch_at_an_edge()
{
  const Test_mesh cube = triangulated(box());
  for (const Test_mesh& soup : with_all_kinds_of_points(merged({cube, translated(cube, {1, 1, 0})})))
    check_solids(soup, {1, 1});
}

// The wall has another diagonal on either side.
void walls_may_be_triangulated_in_two_ways()
{
  const Test_mesh cube = triangulated(box());
  const Test_mesh other = transformed(with_reversed_orientation(cube),
                                      [](const Point& p) {
                                        return Point{2 - p[0], p[1], p[2]};
                                      });
  const Test_mesh turned = transformed(with_reversed_orientation(other),
                                       [](const Point& p) {
                                         return Point{p[0], 1 - p[1], p[2]};
                                       });
  for (const Test_mesh& second : {other, turned})
    for (const Test_mesh& soup : with_all_kinds_of_points(merged({cube, second})))
      check_solids(soup, {1, 1});
}

void wedges_around_an_edge_are_solids()
{
  std::vector<Test_mesh> wedges;
  std::vector<double> volumes;
  for (int i = 0; i < 12; ++i)
  {
    const auto corner = [&](int k) {
      return std::array<double, 2>{std::cos(CGAL_PI * k / 6), std::sin(CGAL_PI * k / 6)};
    };
    wedges.push_back(triangulated(prism({{0, 0}, corner(i), corner(i == 11 ? 0 : i + 1)}, 1)));
    volumes.push_back(volume(wedges.back()));
  }
  for (const Test_mesh& soup : {exploded(merged(wedges)), with_shared_points(merged(wedges))})
    check_solids(soup, volumes);
}

// Duplicates within a surface stay duplicates, those of walls too; so does a solid that is there twice.
void duplicates_are_left_out()
{
  for (const Test_mesh& stack_of_cubes : with_all_kinds_of_points(stack(2, 2, 1)))
  {
    for (std::size_t f = 0; f < stack_of_cubes.faces.size(); ++f)
    {
      Test_mesh soup = stack_of_cubes;
      soup.add_face(soup.faces[f]);
      const Found found = repaired(soup);
      CGAL_CHECK_EQUAL(found.repairs.duplicate_polygons, 1);
      CGAL_CHECK_EQUAL(found.repairs.components, 4);
    }
    const Found twice = repaired(merged({stack_of_cubes, stack_of_cubes}));
    CGAL_CHECK_EQUAL(twice.repairs.duplicate_polygons, stack_of_cubes.faces.size());
    CGAL_CHECK_EQUAL(twice.repairs.components, 4);
  }
  for (const Test_mesh& cube : with_all_kinds_of_points(triangulated(box())))
  {
    const Found found = repaired(merged({cube, with_reversed_orientation(cube)}));
    CGAL_CHECK_EQUAL(found.repairs.duplicate_polygons, 12);
    CGAL_CHECK_EQUAL(found.repairs.components, 1);
  }
}

// A tetrahedron of the six around the diagonal of a cube.
Test_mesh sixth_of_cube(const std::array<std::size_t, 3>& axes)
{
  Test_mesh result;
  Point corner = {0, 0, 0};
  result.add_point(corner);
  for (const std::size_t axis : axes)
  {
    corner[axis] = 1;
    result.add_point(corner);
  }
  for (const Face& face : {Face{0, 2, 1}, Face{0, 1, 3}, Face{0, 3, 2}, Face{1, 2, 3}})
    result.add_face(face);
  return volume(result) < 0 ? with_reversed_orientation(result) : result;
}

// The cubes of a random walk, which touch at faces, edges and corners, or some of the tetrahedra in them.
std::vector<Test_mesh> random_solids(Random& random)
{
  std::vector<Test_mesh> solids;
  std::set<Point> cubes;
  Point cube = {0, 0, 0};
  const std::size_t number = 2 + random.index(6);
  const int n = 1 + int(random.index(3));
  const bool are_cubes = random.index(2) == 0;
  while (cubes.size() < number)
  {
    std::array<std::size_t, 3> axes = {0, 1, 2};
    if (!cubes.insert(cube).second)
      ;
    else if (are_cubes)
      solids.push_back(translated(scaled(triangulated(box(n, n, n)), 1. / n), cube));
    else
      do
        if (random.index(3) != 0)
          solids.push_back(translated(sixth_of_cube(axes), cube));
      while (std::next_permutation(axes.begin(), axes.end()));
    for (double& x : cube)
      x += double(random.index(3)) - 1;
  }
  return solids;
}

// Also if the corners of the triangles differ by a unit in the last place of single precision.
void random_solids_that_touch()
{
  for (std::uint_fast32_t seed = 0; seed < 300; ++seed)
  {
    Random random(seed);
    const std::vector<Test_mesh> solids = random_solids(random);
    std::vector<double> volumes;
    for (const Test_mesh& solid : solids)
      volumes.push_back(volume(solid));
    const Test_mesh soup = exploded(merged(solids));
    const Test_mesh mixed = with_face_order(soup, random_permutation(soup.faces.size(), seed));
    check_solids(mixed, volumes);
    const float limits[] = {-1e9f, 0, 1e9f};
    check_solids(transformed(translated(mixed, {1. / 3, 1. / 7, 1. / 9}),
                             [&](Point p)
                             {
                               for (double& x : p)
                                 if (const std::size_t i = random.index(3); i != 1)
                                   x = double(std::nextafter(float(x), limits[i]));
                                 else
                                   x = double(float(x));
                               return p;
                             }),
                 volumes, 1e-4);
  }
}

int main()
{
  random_solids_that_touch();
  cubes_of_a_stack_are_solids();
  solids_may_be_turned_inside_out();
  solids_may_be_anywhere();
  solids_may_touch_at_an_edge();
  walls_may_be_triangulated_in_two_ways();
  wedges_around_an_edge_are_solids();
  duplicates_are_left_out();
  return check::result();
}
