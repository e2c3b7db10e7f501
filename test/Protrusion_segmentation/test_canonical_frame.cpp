// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The frame that a surface is segmented in: the same wherever it lies, on whichever side and however large it is.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Mesh/read_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/canonical_frame.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Canonical_surface;
using internal::Compensated_sum;
using internal::Matrix_3;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

constexpr double rounding = 1e-9; // of coordinates

Canonical_surface canonical(const Test_mesh& mesh)
{
  return Canonical_surface(internal::read_arrays(to_graph<Mesh>(mesh), CGAL::parameters::default_values()));
}

void axes_are_eigenvectors()
{
  Random random(7);
  const auto number = [&random]() { return random.real(-0.5, 0.5); };
  for (int i = 0; i < 1000; ++i)
  {
    Matrix_3 m = {};
    for (int a = 0; a < 3; ++a)
      for (int b = a; b < 3; ++b)
        m[a][b] = m[b][a] = i % 5 == 0 && a != b ? 0 : number();
    const Matrix_3 axes = internal::principal_axes(m);
    std::vector<double> eigenvalues;
    for (const auto& axis : axes)
    {
      Point image = {0, 0, 0};
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          image[a] += m[a][b] * axis[b];
      const Point direction = {axis[0], axis[1], axis[2]};
      CGAL_CHECK_CLOSE(length(direction), 1, 1e-12);
      eigenvalues.push_back(dot(image, direction));
      CGAL_CHECK_CLOSE(length(image - eigenvalues.back() * direction), 0, 1e-12);
    }
    CGAL_CHECK(eigenvalues[0] >= eigenvalues[1] - 1e-12 && eigenvalues[1] >= eigenvalues[2] - 1e-12);
  }
}

// The sum of one and a hundred thousand small terms, in any order.
void sums_do_not_depend_on_the_order()
{
  std::vector<double> terms(1, 1.);
  for (int i = 1; i <= 100000; ++i)
    terms.push_back((i % 2 == 0 ? 1 : -1) / (3. + i));
  std::mt19937 random(1);
  const auto sum = [&terms](std::size_t number_of_blocks)
  {
    Compensated_sum result;
    const std::size_t size = terms.size() / number_of_blocks;
    for (std::size_t b = 0; b < number_of_blocks; ++b)
    {
      Compensated_sum block;
      for (std::size_t i = b * size; i < (b + 1 < number_of_blocks ? (b + 1) * size : terms.size()); ++i)
        block += terms[i];
      result = result + block;
    }
    return result.value();
  };
  const double expected = sum(1);
  for (std::size_t i = 1; i < 30; ++i)
  {
    std::shuffle(terms.begin(), terms.end(), random);
    CGAL_CHECK_EQUAL(sum(i), expected);
  }
}

// Its longest side along the first axis, about its middle.
void a_box_lies_along_its_axes()
{
  Test_mesh mesh = triangulated(box(4, 2, 1));
  for (Point& p : mesh.points)
    p = {p[2], p[0], p[1]};
  const Canonical_surface found = canonical(translated(mesh, {5, 6, 7}));
  Point largest = {0, 0, 0};
  for (Index v = 0; v < found.surface().number_of_vertices(); ++v)
    for (int a = 0; a < 3; ++a)
      largest[a] = (std::max)(largest[a], std::abs(found.surface().point(v)[a]));
  CGAL_CHECK_CLOSE(largest[0], 1, rounding);
  CGAL_CHECK_CLOSE(largest[1], 0.5, rounding);
  CGAL_CHECK_CLOSE(largest[2], 0.25, rounding);
  CGAL_CHECK_CLOSE(found.unit(), 2, 1e-12);
}

void check_same_surface(const Canonical_surface& found, const Canonical_surface& expected)
{
  const Indexed_surface &a = found.surface(), &b = expected.surface();
  CGAL_CHECK(found.positions() == expected.positions());
  CGAL_CHECK_EQUAL(a.number_of_vertices(), b.number_of_vertices());
  CGAL_CHECK_EQUAL(a.number_of_corners(), b.number_of_corners());
  bool are_same = true;
  for (Index v = 0; v < a.number_of_vertices(); ++v)
    are_same = are_same && a.point(v) == b.point(v);
  for (Index f = 0; f <= a.number_of_faces(); ++f)
    are_same = are_same && a.first_corner(f) == b.first_corner(f);
  for (Index c = 0; c < a.number_of_corners(); ++c)
    are_same = are_same && a.vertex(c) == b.vertex(c) && a.neighbor(c) == b.neighbor(c);
  CGAL_CHECK(are_same);
}

// To the last bit, with lengths that are those of the mesh.
void moved_turned_mirrored_and_scaled_surfaces_are_the_same()
{
  for (std::uint_fast32_t seed = 1; seed <= 20; ++seed)
  {
    const Test_mesh mesh = seed % 2 == 0 ? jittered(star(4, 2, 0.25, 0.1, 0.2), 0.02, seed) : bumpy_sphere(3, seed);
    const Canonical_surface expected = canonical(mesh);
    const Point axis = {1, static_cast<double>(seed % 5) - 2, 0.5};
    const Test_mesh turned = rotated(mesh, axis, 0.3 * static_cast<double>(seed));
    for (const Test_mesh& same :
         {translated(mesh, {1, 20, -3}), turned, with_reversed_orientation(scaled(mesh, 1, -1, 1)),
          with_reversed_orientation(scaled(turned, -1, 1, 1)), scaled(mesh, -1, -1, 1)})
    {
      check_same_surface(canonical(same), expected);
      CGAL_CHECK_CLOSE(canonical(same).unit() / expected.unit(), 1, 1e-12);
    }
    check_same_surface(canonical(scaled(turned, 1000)), expected);
    CGAL_CHECK_CLOSE(canonical(scaled(turned, 1000)).unit() / expected.unit(), 1000, 1e-9);
  }
}

double volume(const Indexed_surface& surface)
{
  double sum = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    sum += surface.area_vector(f) * (surface.centroid(f) - CGAL::ORIGIN) / 3;
  return sum;
}

// What is outside stays outside, and areas, lengths and neighbours are those of the mesh.
void the_surface_stays_what_it_is()
{
  for (std::uint_fast32_t seed = 1; seed <= 20; ++seed)
  {
    const Test_mesh mesh = seed % 2 == 0 ? bumpy_sphere(2, seed) : with_reversed_orientation(bumpy_sphere(2, seed));
    const Indexed_surface before = to_surface(mesh);
    const Canonical_surface found = canonical(mesh);
    const Indexed_surface& after = found.surface();
    const double scale = found.unit();
    CGAL_CHECK_CLOSE(volume(after) * scale * scale * scale, volume(before), 1e-7);
    for (Index f = 0; f < after.number_of_faces(); ++f)
    {
      const Index origin = found.positions()[f];
      CGAL_CHECK_CLOSE(after.area(f) * scale * scale, before.area(origin), 1e-7);
      std::vector<std::pair<Index, double>> expected, edges; // beyond each edge, and how long it is
      for (Index c = before.first_corner(origin); c < before.first_corner(origin + 1); ++c)
        expected.emplace_back(before.neighbor(c), before.edge_length(origin, c));
      for (Index c = after.first_corner(f); c < after.first_corner(f + 1); ++c)
        edges.emplace_back(found.positions()[after.neighbor(c)], after.edge_length(f, c) * scale);
      std::sort(expected.begin(), expected.end());
      std::sort(edges.begin(), edges.end());
      for (std::size_t i = 0; i < edges.size(); ++i)
      {
        CGAL_CHECK_EQUAL(edges[i].first, expected[i].first);
        CGAL_CHECK_CLOSE(edges[i].second, expected[i].second, 1e-7);
      }
    }
  }
}

// The points of the surface count, not those of the mesh: where there are more triangles, the frame stays.
void the_frame_does_not_depend_on_the_triangles()
{
  for (std::uint_fast32_t seed = 1; seed <= 10; ++seed)
  {
    const Test_mesh mesh = bumpy_sphere(2, seed);
    Test_mesh finer = mesh;
    for (std::size_t f = 0; f < mesh.faces.size(); f += 3)
    {
      const Face face = mesh.faces[f];
      Point sum = {0, 0, 0};
      for (const std::size_t v : face)
        sum = sum + mesh.points[v];
      const std::size_t centre = finer.add_point((1. / 3) * sum);
      finer.faces[f] = {face[0], face[1], centre};
      finer.faces.push_back({face[1], face[2], centre});
      finer.faces.push_back({face[2], face[0], centre});
    }
    const auto places = [](const Test_mesh& soup)
    {
      const Canonical_surface surface = canonical(soup);
      std::vector<Indexed_surface::Point_3> result;
      for (Index v = 0; v < surface.surface().number_of_vertices(); ++v)
        result.push_back(surface.surface().point(v));
      std::sort(result.begin(), result.end());
      return result;
    };
    const auto few = places(mesh), many = places(finer);
    for (const auto& p : few)
      CGAL_CHECK(std::any_of(many.begin(), many.end(),
                        [&p](const auto& q) { return CGAL::squared_distance(p, q) < rounding * rounding * 4; }));
  }
}

void nothing_and_next_to_nothing()
{
  for (const Test_mesh& mesh : {scaled(icosphere(1), 0), scaled(icosphere(1), 1, 0, 0), scaled(icosphere(1), 1e-300),
                                scaled(icosphere(1), 1e300), single_triangle(), thin_strip(32)})
  {
    const Canonical_surface found = canonical(mesh);
    for (Index v = 0; v < found.surface().number_of_vertices(); ++v)
      for (int a = 0; a < 3; ++a)
        CGAL_CHECK(std::abs(found.surface().point(v)[a]) <= 1);
  }
}

int main()
{
  axes_are_eigenvectors();
  sums_do_not_depend_on_the_order();
  a_box_lies_along_its_axes();
  moved_turned_mirrored_and_scaled_surfaces_are_the_same();
  the_surface_stays_what_it_is();
  the_frame_does_not_depend_on_the_triangles();
  nothing_and_next_to_nothing();
  return check::result();
}
