// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Borders that nearly agree are sewn: corners that differ by rounding, and cracks.

#include "check.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/polygon_soup_to_manifold_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

using namespace test_meshes;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

struct Found
{
  CGAL::Protrusion_segmentation::Polygon_soup_repairs repairs;
  std::size_t border_edges = 0;
  std::size_t faces = 0;
  std::size_t largest_face = 0;
};

Found repaired(const Test_mesh& soup, std::optional<double> tolerance = std::nullopt)
{
  using CGAL::Protrusion_segmentation::polygon_soup_to_manifold_mesh;
  std::vector<Point_3> points;
  for (const Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  Mesh mesh;
  const auto found = tolerance
                       ? polygon_soup_to_manifold_mesh(points, soup.faces, mesh,
                                                       CGAL::parameters::snapping_tolerance(*tolerance))
                       : polygon_soup_to_manifold_mesh(points, soup.faces, mesh);
  Found result = {found.repairs, 0, mesh.number_of_faces(), 0};
  CGAL_CHECK(mesh.is_valid(false));
  for (const auto h : mesh.halfedges())
    result.border_edges += mesh.is_border(h) ? 1 : 0;
  for (const auto f : mesh.faces())
    result.largest_face = (std::max)(result.largest_face, std::size_t(mesh.degree(f)));
  CGAL_CHECK_EQUAL(found.face_of_polygon.size(), soup.faces.size());
  return result;
}

// Every face with points of its own, each coordinate moved by up to `distance`.
Test_mesh shaken(const Test_mesh& mesh, double distance, std::uint_fast32_t seed)
{
  Random random(seed);
  Test_mesh result;
  for (const Face& face : mesh.faces)
  {
    Face own;
    for (const std::size_t v : face)
      own.push_back(result.add_point(mesh.points[v] + Point{random.real(-distance, distance),
                                                            random.real(-distance, distance),
                                                            random.real(-distance, distance)}));
    result.add_face(own);
  }
  return result;
}

Test_mesh in_single_precision(Test_mesh mesh, double share_of_changed, std::uint_fast32_t seed)
{
  Random random(seed);
  for (Point& p : mesh.points)
    for (double& x : p)
    {
      const float f = static_cast<float>(x);
      x = random.real(0, 1) < share_of_changed ? std::nextafter(f, random.index(2) == 0 ? -10.f : 10.f)
                                               : f;
    }
  return mesh;
}

void check_sewn(const Test_mesh& soup, std::optional<double> tolerance = std::nullopt)
{
  const Found found = repaired(soup, tolerance);
  CGAL_CHECK_EQUAL(found.repairs.components, 1);
  CGAL_CHECK_EQUAL(found.border_edges, 0);
  CGAL_CHECK_EQUAL(found.faces, soup.faces.size());
  CGAL_CHECK(found.repairs.joined_corners > 0);
  CGAL_CHECK(!found.repairs.is_nothing());
}

void corners_that_differ_by_a_millionth_of_the_size_are_one()
{
  for (std::uint_fast32_t seed = 0; seed < 10; ++seed)
    for (const double unit : {1e-3, 1., 1e6})
    {
      check_sewn(shaken(scaled(icosphere(3), unit), 1e-6 * unit, seed));
      check_sewn(shaken(scaled(triangulated(box(2, 3, 4)), unit), 1e-6 * unit, seed));
      check_sewn(shaken(scaled(star(5, 2, 0.25, 0.1, 0.2), unit), 1e-6 * unit, seed));
    }
}

void last_bits_of_single_precision_do_not_matter()
{
  for (std::uint_fast32_t seed = 0; seed < 10; ++seed)
    for (const Point& place : {Point{0, 0, 0}, Point{100, 0, -30}})
      for (const double share : {.01, .05, .5})
        check_sewn(in_single_precision(shaken(translated(icosphere(3), place), 0, 0), share, seed));
}

// Walls of solids that touch agree with each other, and nearly so.
void solids_that_touch_are_sewn()
{
  std::vector<Test_mesh> cubes;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 2; ++z)
        cubes.push_back(translated(triangulated(box()), {1. * x, 1. * y, 1. * z}));
  for (std::uint_fast32_t seed = 0; seed < 20; ++seed)
  {
    const Test_mesh stack = translated(rotated(merged(cubes), {0, seed % 2 == 0 ? 0. : 1., 1}, .5),
                                       {.3, .2, .1});
    for (const Test_mesh& soup :
         {shaken(stack, 1e-6, seed), in_single_precision(shaken(stack, 0, 0), .01, seed),
          in_single_precision(shaken(stack, 0, 0), .05, seed)})
    {
      const Found found = repaired(soup);
      CGAL_CHECK_EQUAL(found.repairs.components, cubes.size());
      CGAL_CHECK_EQUAL(found.border_edges, 0);
      CGAL_CHECK_EQUAL(found.faces, soup.faces.size());
    }
  }
}

void other_corners_are_apart()
{
  const Test_mesh soup = shaken(icosphere(2), 1e-3, 1);
  CGAL_CHECK_EQUAL(repaired(soup).repairs.components, soup.faces.size());
  CGAL_CHECK_EQUAL(repaired(soup).repairs.joined_corners, 0);
  check_sewn(soup, 1e-2);
  CGAL_CHECK_EQUAL(repaired(shaken(icosphere(2), 1e-7, 1), 0.).repairs.components, soup.faces.size());
}

void tolerances_are_distances()
{
  for (const double tolerance :
       {-1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    CGAL_CHECK_THROWS_WITH(repaired(icosphere(1), tolerance), std::invalid_argument, "snapping_tolerance");
}

// However large the tolerance is, no edge vanishes, and nothing that is closed changes.
void no_edge_vanishes()
{
  for (const double tolerance : {1e-3, 1e-1, 10.})
  {
    CGAL_CHECK(repaired(icosphere(2), tolerance).repairs.is_nothing());
    const Found sheets = repaired(merged({sheet(5, 5), translated(sheet(5, 5), {0, 0, 3})}), tolerance);
    CGAL_CHECK_EQUAL(sheets.faces, 50);
    const Test_mesh soup = shaken(icosphere(2), 1e-4, 1);
    CGAL_CHECK_EQUAL(repaired(soup, tolerance).faces, soup.faces.size());
  }
}

// A sheet beside one with twice as many edges along the border, at most `gap` apart.
Test_mesh cracked_sheet(double gap)
{
  const Test_mesh coarse = sheet(3, 3), fine = translated(sheet(6, 6, .5, .5), {3 + gap, 0, 0});
  return merged({coarse, fine});
}

void corners_on_edges_are_sewn()
{
  for (const double gap : {0., 1e-6})
  {
    const Found found = repaired(cracked_sheet(gap));
    CGAL_CHECK_EQUAL(found.repairs.components, 1);
    CGAL_CHECK_EQUAL(found.repairs.split_edges, 3);
    CGAL_CHECK_EQUAL(found.border_edges, 9 + 18);
    CGAL_CHECK_EQUAL(found.largest_face, 5);
  }
  CGAL_CHECK_EQUAL(repaired(cracked_sheet(.01)).repairs.components, 2);
  CGAL_CHECK_EQUAL(repaired(cracked_sheet(.01), .02).repairs.components, 1);
  CGAL_CHECK_EQUAL(repaired(cracked_sheet(0), 0.).repairs.components, 2);
}

// Sheets that touch at a corner, or along parts of their edges, are as they are.
void touching_is_not_enough()
{
  const Test_mesh one = sheet(1, 1);
  for (const Test_mesh& other :
       {translated(sheet(1, 1), {1, .5, 0}), translated(rotated(sheet(1, 1), {0, 0, 1}, .7), {1, .5, 0})})
  {
    const Found found = repaired(merged({one, other}));
    CGAL_CHECK(found.repairs.is_nothing());
    CGAL_CHECK_EQUAL(found.repairs.components, 2);
  }
}

void the_order_of_the_polygons_does_not_matter()
{
  const Test_mesh soup = shaken(icosphere(2), 1e-4, 3);
  const Found found = repaired(soup, 2e-4);
  for (std::uint_fast32_t seed = 0; seed < 5; ++seed)
  {
    const Found other = repaired(with_face_order(soup, random_permutation(soup.faces.size(), seed)),
                                 2e-4);
    CGAL_CHECK_EQUAL(other.repairs.joined_corners, found.repairs.joined_corners);
    CGAL_CHECK_EQUAL(other.border_edges, found.border_edges);
  }
}

// Whatever is sewn, a manifold comes out.
void wild_soups_become_manifolds()
{
  for (std::uint_fast32_t seed = 0; seed < 1000; ++seed)
  {
    Random random(seed);
    Test_mesh soup;
    for (std::size_t i = 0; i < 12; ++i)
      soup.add_point({random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)});
    soup.add_face({0, 1, 2});
    for (std::size_t i = 0; i < 30; ++i)
    {
      Face face;
      for (int c = 0; c < 3; ++c)
      {
        const Point near = {random.real(-.01, .01), random.real(-.01, .01), random.real(-.01, .01)};
        const std::size_t point = random.index(12);
        face.push_back(random.index(2) == 0 ? point : soup.add_point(soup.points[point] + near));
      }
      soup.add_face(face);
    }
    for (const double tolerance : {.01, .03, .5})
      repaired(soup, tolerance);
  }
}

int main()
{
  corners_that_differ_by_a_millionth_of_the_size_are_one();
  last_bits_of_single_precision_do_not_matter();
  solids_that_touch_are_sewn();
  other_corners_are_apart();
  tolerances_are_distances();
  no_edge_vanishes();
  corners_on_edges_are_sewn();
  touching_is_not_enough();
  the_order_of_the_polygons_does_not_matter();
  wild_soups_become_manifolds();
  return check::result();
}
