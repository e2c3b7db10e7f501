// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Averaged normals; sheets cut out of a plane, whose outline alone shows what sticks out.

#include "check.h"
#include "dual_graphs.h"
#include "flat_shapes.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Border_edges.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Border_roof.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/average_normals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>

using namespace test_meshes;

void normals_of_a_sphere_point_outward()
{
  const Indexed_surface surface = to_surface(jittered(icosphere(4), 0.005, 1));
  const auto graph = seam_graph(surface);
  const auto centre = centres(surface);
  const CGAL::Protrusion_segmentation::internal::Surface_average average(
    graph, centre, CGAL::Protrusion_segmentation::internal::normal_radius / 9, quiet_execution());
  const auto normals = CGAL::Protrusion_segmentation::internal::average_normals(surface, average, quiet_execution());
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    const Indexed_surface::Vector_3 radius = surface.centroid(f) - Indexed_surface::Point_3(0, 0, 0);
    const Indexed_surface::Vector_3 normal(normals[f][0], normals[f][1], normals[f][2]);
    CGAL_CHECK_CLOSE(normal.squared_length(), 1, 1e-6);
    CGAL_CHECK(normal * radius > 0.98 * std::sqrt(radius.squared_length()));
  }
}

void what_is_open()
{
  const auto is_open = [](const Test_mesh& mesh)
  { return !CGAL::Protrusion_segmentation::internal::Border_edges(to_surface(mesh))().empty(); };
  CGAL_CHECK(is_open(flat_star(5, 30)));
  CGAL_CHECK(!is_open(icosphere(2)));
}

// The roof over a half sphere falls towards the border, whichever side normals point to, and by less far away.
void a_roof_falls_towards_the_border()
{
  Test_mesh half = icosphere(4);
  half.faces.erase(std::remove_if(half.faces.begin(), half.faces.end(),
                                  [&](const Face& face) {
                                    return std::any_of(face.begin(), face.end(),
                                                       [&](std::size_t v)
                                                       { return half.points[v][2] < 0; });
                                  }),
                   half.faces.end());
  for (const Test_mesh& mesh : {half, with_reversed_orientation(half)})
  {
    const Indexed_surface surface = to_surface(mesh);
    const auto graph = seam_graph(surface);
    const auto centre = centres(surface);
    const CGAL::Protrusion_segmentation::internal::Surface_average average(
      graph, centre, CGAL::Protrusion_segmentation::internal::normal_radius / 9, quiet_execution());
    const CGAL::Protrusion_segmentation::internal::Surface_average coarse_average(
      average, CGAL::Protrusion_segmentation::internal::outline_radius / 7);
    const auto normals = CGAL::Protrusion_segmentation::internal::average_normals(surface, average, quiet_execution());
    const CGAL::Protrusion_segmentation::internal::Border_edges border(surface);
    const auto roof =
      CGAL::Protrusion_segmentation::internal::Border_roof(surface, border, quiet_execution())(normals, coarse_average);
    for (Index f = 0; f < surface.number_of_faces(); ++f)
    {
      const double height = surface.centroid(f).z();
      if (height < 0.1)
        CGAL_CHECK(roof[f][2] < -1);
      if (height > 0.9)
        CGAL_CHECK(std::abs(roof[f][2]) < 0.1);
    }
  }
}

// What is convex has no parts, and a ring has no ends.
void no_parts_without_concave_corners()
{
  const auto inside = [](bool is_inside) { return is_inside ? 0 : outside; };
  CGAL_CHECK_EQUAL(
    automatic_segmentation(flat_shape([&](double x, double y) { return inside(std::hypot(x, y) < 0.95); })).number, 1u);
  CGAL_CHECK_EQUAL(automatic_segmentation(
                flat_shape([&](double x, double y) { return inside(std::abs(x) < 0.8 && std::abs(y) < 0.8); }))
                .number,
              1u);
  CGAL_CHECK_EQUAL(automatic_segmentation(flat_shape([&](double, double y) { return inside(std::abs(y) < 0.2); })).number,
              1u);
  CGAL_CHECK_EQUAL(
    automatic_segmentation(flat_shape([&](double x, double y) { return inside(x * x + 4 * y * y < 0.9); })).number, 1u);
  CGAL_CHECK_EQUAL(automatic_segmentation(
                flat_shape([&](double x, double y) { return inside(std::abs(std::hypot(x, y) - 0.7) < 0.2); }))
                .number,
              1u);
}

void arms_are_parts()
{
  constexpr double least_share = 0.97;
  check_parts(flat_star(5, 90), automatic_segmentation(flat_star(5, 90)), least_share);
  check_parts(flat_star(6, 140), automatic_segmentation(flat_star(6, 140)), least_share);
  check_parts(flat_dumbbell(), automatic_segmentation(flat_dumbbell()), least_share);
}

// Arms that taper, of a sheet with a jagged outline, are neither cut in two nor left with the disk: all of one turn, and 10 of 12
// of another one.
void tapering_arms_are_whole()
{
  int right = 0;
  for (const int arms : {3, 4, 5})
    for (const int cells : {64, 90, 120, 140})
    {
      const Test_mesh mesh = star_with_tapering_arms(arms, cells, 0.13);
      check_parts(mesh, automatic_segmentation(mesh), 0.9);
      const Test_mesh turned = star_with_tapering_arms(arms, cells, 0.4);
      const Segmentation found = automatic_segmentation(turned);
      right += found.number == number_of_parts(turned) && share_in_true_parts(turned, found.labels) > 0.9;
    }
  CGAL_CHECK(right >= 10);
}

// The same of few triangles, four to nine across the root of an arm: the zigzag of the outline is no place to cut, though it may be.
void a_zigzag_has_no_corners()
{
  int right = 0;
  for (const int arms : {3, 4, 5, 6})
    for (const int cells : {44, 52, 60, 68})
      for (const double turned : {0., 0.1, 0.2, 0.3, 0.4})
      {
        const Test_mesh mesh = star_with_tapering_arms(arms, cells, turned);
        const Segmentation found = automatic_segmentation(mesh);
        right += found.number == number_of_parts(mesh) && share_in_true_parts(mesh, found.labels) > 0.9;
      }
  std::cout << right << " of 80 coarse stars are right\n";
  CGAL_CHECK(right >= 61);
}

void figures_have_head_arms_and_legs()
{
  for (const int cells : {60, 90, 120})
    check_parts(flat_figure(cells), automatic_segmentation(flat_figure(cells)), 0.95);
}

// A sheet may be bent as a roof or a saddle, or sag, by little or much.
void bent_sheets_have_the_parts_of_flat_ones()
{
  const std::function<double(double, double)> heights[] = {
    [](double x, double y) { return x * y; }, [](double x, double y) { return x * x + y * y; },
    [](double x, double) { return x * x; }};
  constexpr double least_share = 0.95;
  for (const Test_mesh& plane : {flat_star(5, 90), flat_dumbbell()})
    for (const auto& height : heights)
      for (const double size : {1e-4, 1e-2, 0.2})
      {
        Test_mesh bent = plane;
        for (Point& p : bent.points)
          p[2] = size * height(p[0], p[1]);
        check_parts(bent, automatic_segmentation(bent), least_share);
      }
}

void place_and_size_do_not_count()
{
  const Test_mesh plane = flat_star(5, 90);
  const Labels labels = as_partition(automatic_segmentation(plane).labels);
  for (const Test_mesh& moved :
       {translated(plane, {5, -3, 2}), scaled(plane, 1000),
        translated(rotated(plane, {1, 1, 0}, 2), {0, 100, 0}), with_reversed_orientation(plane)})
    CGAL_CHECK(share_in_true_parts(plane, automatic_segmentation(moved).labels) >= 0.97);
  CGAL_CHECK_EQUAL(as_partition(automatic_segmentation(translated(plane, {0, 0, 4})).labels) == labels, true);
}

// A polygon of many edges with a triangle on each: faces that have no neighbour but one do not come together to groups.
void a_face_may_have_all_others_around_it()
{
  constexpr std::size_t teeth = 3000;
  Test_mesh mesh;
  Face hub;
  for (std::size_t i = 0; i < 2 * teeth; ++i)
  {
    const double angle = pi * double(i) / teeth, radius = i % 2 == 0 ? 1 : 1.01;
    mesh.add_point({radius * std::cos(angle), radius * std::sin(angle), 0});
    if (i % 2 == 0)
      hub.push_back(i);
  }
  mesh.add_face(hub);
  for (std::size_t i = 0; i < 2 * teeth; i += 2)
    mesh.add_face({i, i + 1, (i + 2) % (2 * teeth)});
  CGAL_CHECK_EQUAL(automatic_segmentation(mesh).number, 1u);
}

int main()
{
  normals_of_a_sphere_point_outward();
  what_is_open();
  a_roof_falls_towards_the_border();
  no_parts_without_concave_corners();
  arms_are_parts();
  tapering_arms_are_whole();
  a_zigzag_has_no_corners();
  figures_have_head_arms_and_legs();
  bent_sheets_have_the_parts_of_flat_ones();
  place_and_size_do_not_count();
  a_face_may_have_all_others_around_it();
  return check::result();
}
