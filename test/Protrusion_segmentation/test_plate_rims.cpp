// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rims of thin plates, and the parts of plates that only their outlines show.

#include "check.h"
#include "dual_graphs.h"
#include "flat_shapes.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Plate_rims.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

constexpr double least_share = 0.92; // of the area, in the true part

Test_mesh flat_disk(int cells)
{
  return flat_shape([](double x, double y) { return std::hypot(x, y) < 0.95 ? 0 : outside; }, cells);
}

Test_mesh flat_washer(int cells)
{
  return flat_shape([](double x, double y) { return std::abs(std::hypot(x, y) - 0.7) < 0.2 ? 0 : outside; }, cells);
}

Test_mesh flat_square(int cells)
{
  return flat_shape([](double x, double y) { return std::abs(x) < 0.8 && std::abs(y) < 0.8 ? 0 : outside; }, cells);
}

// Of every face; nothing if there is none.
std::vector<bool> rims(const Test_mesh& mesh)
{
  const Indexed_surface surface = to_surface(mesh);
  const auto graph = seam_graph(surface);
  const auto centre = centres(surface);
  return CGAL::Protrusion_segmentation::internal::Plate_rims(surface)(CGAL::Protrusion_segmentation::internal::Surface_average(
    graph, centre, CGAL::Protrusion_segmentation::internal::outline_radius / 7, quiet_execution()));
}

// The walls and nothing else, wherever the plate is, of few and many triangles; of narrow arms not all.
void walls_of_plates_are_rims()
{
  for (const int cells : {24, 90})
    for (const auto& [plane, share] : {std::pair(flat_disk(cells), 1.), std::pair(flat_washer(cells), 1.),
                                       std::pair(flat_square(cells), 1.), std::pair(flat_star(5, cells), 0.5)})
    {
      const Test_mesh mesh = thickened(plane, 0.05);
      const std::ptrdiff_t walls = std::ptrdiff_t(mesh.faces.size() - 2 * plane.faces.size());
      for (const Test_mesh& moved : {mesh, translated(rotated(mesh, {1, 1, 0}, 2), {0, 100, 0}), scaled(mesh, 1000)})
      {
        const std::vector<bool> found = rims(moved);
        CGAL_CHECK_EQUAL(found.size(), mesh.faces.size());
        const auto of_walls = std::count(found.end() - walls, found.end(), true);
        CGAL_CHECK(double(of_walls) >= share * double(walls));
        CGAL_CHECK_EQUAL(std::count(found.begin(), found.end(), true), of_walls);
      }
    }
}

// Corners, too, however thick the plate is.
void walls_are_rims_as_a_whole_or_not_at_all()
{
  for (int i = 1; i <= 20; ++i)
    for (const Test_mesh& plane : {flat_square(44), flat_square(60), flat_disk(60)})
    {
      const Test_mesh mesh = thickened(plane, 0.02 * i);
      const std::vector<bool> found = rims(mesh);
      const auto walls = std::ptrdiff_t(mesh.faces.size() - 2 * plane.faces.size());
      const std::ptrdiff_t number = std::count(found.begin(), found.end(), true);
      CGAL_CHECK(number == 0 || number == walls);
    }
}

// A step across a sheet, a twentieth as high as that is wide, which looks to one side only.
Test_mesh cliff()
{
  constexpr std::size_t cells = 80;
  Test_mesh mesh = sheet(cells, cells);
  for (Point& p : mesh.points)
    p[2] = p[0] > cells / 2. ? cells / 20. : 0;
  return mesh;
}

void what_is_no_plate_has_no_rim()
{
  for (const Test_mesh& mesh : {box(12, 12, 12), icosphere(4), torus(), capsule(), dumbbell(), star(5), creature(),
                                bumpy_sphere(4, 1), thickened(flat_square(24), 0.8), flat_star(5, 30), cliff(), tetrahedron(),
                                single_triangle()})
    CGAL_CHECK(rims(mesh).empty());
}

// Rims ended before corners, which were cut off.
void square_plates_are_whole()
{
  for (const double thickness : {0.06, 0.08, 0.1, 0.12})
    for (const int cells : {30, 44, 52, 68})
      CGAL_CHECK_EQUAL(automatic_segmentation(thickened(flat_square(cells), thickness)).number, 1u);
}

void plates_without_concave_corners_are_whole()
{
  for (const double thickness : {0.02, 0.05, 0.1, 0.2})
    for (const Test_mesh& plane : {flat_disk(60), flat_washer(60), flat_square(60)})
      CGAL_CHECK_EQUAL(automatic_segmentation(thickened(plane, thickness)).number, 1u);
}

// A thin star was one piece.
void arms_of_plates_are_parts()
{
  for (const double thickness : {0.02, 0.05})
    for (const Test_mesh& plane : {flat_star(5, 60), flat_star(6, 90), flat_figure(90), flat_dumbbell()})
    {
      const Test_mesh mesh = thickened(plane, thickness);
      check_parts(mesh, automatic_segmentation(mesh), least_share);
    }
}

void bent_plates_have_the_parts_of_flat_ones()
{
  for (const double size : {1e-3, 0.05, 0.2})
    for (const Test_mesh& plane : {flat_star(5, 60), flat_figure(90)})
    {
      Test_mesh mesh = thickened(plane, 0.05);
      for (Point& p : mesh.points)
        p[2] += size * p[0] * p[0];
      check_parts(mesh, automatic_segmentation(mesh), least_share);
    }
}

} // namespace

int main()
{
  walls_of_plates_are_rims();
  walls_are_rims_as_a_whole_or_not_at_all();
  what_is_no_plate_has_no_rim();
  square_plates_are_whole();
  plates_without_concave_corners_are_whole();
  arms_of_plates_are_parts();
  bent_plates_have_the_parts_of_flat_ones();
  return check::result();
}
