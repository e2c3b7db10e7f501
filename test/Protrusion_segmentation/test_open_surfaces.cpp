// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What sticks out of a surface without an underside, as of a scan from one side, is found whatever its height and the
// orientation of the faces. Small holes, as scanners leave them, change no number. Pipes with open ends have the segments of
// closed ones, and the hills of terrain are none. Coarse triangles at the outline of a sheet cut no part of it in two.

#include "implicit_mesh.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

using namespace test_meshes;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

namespace {

// A plate of radius 3, part 0, with a peg of radius 1, part 1. Neither has an underside.
Test_mesh plate_with_peg(double height)
{
  constexpr std::size_t around = 48;
  constexpr double step = 0.15;
  std::vector<std::pair<double, double>> profile; // radius and height, from the rim of the plate to the middle of the peg
  const auto add_line = [&](double r, double z, double to_r, double to_z)
  {
    const int n = static_cast<int>(std::ceil(std::hypot(to_r - r, to_z - z) / step));
    for (int i = 0; i < n; ++i)
      profile.emplace_back(r + (to_r - r) * i / n, z + (to_z - z) * i / n);
  };
  add_line(3, 0, 1, 0);
  const std::size_t foot = profile.size();
  add_line(1, 0, 1, height);
  add_line(1, height, 0, height);
  Test_mesh mesh;
  for (const auto& [r, z] : profile)
    for (std::size_t a = 0; a < around; ++a)
      mesh.add_point({r * std::cos(2 * pi * a / around), r * std::sin(2 * pi * a / around), z});
  const std::size_t top = mesh.add_point({0, 0, height});
  for (std::size_t ring = 0; ring < profile.size(); ++ring)
    for (std::size_t a = 0; a < around; ++a)
    {
      const std::size_t p = ring * around + a, q = ring * around + (a + 1) % around;
      const std::size_t part = ring < foot ? 0 : 1;
      if (ring + 1 == profile.size())
        mesh.add_face({p, q, top}, part);
      else
      {
        mesh.add_face({p, q, q + around}, part);
        mesh.add_face({p, q + around, p + around}, part);
      }
    }
  return mesh;
}

Test_mesh turned(Test_mesh mesh)
{
  for (Face& face : mesh.faces)
    std::reverse(face.begin(), face.end());
  return mesh;
}

Segmentation segmentation(const Test_mesh& soup)
{
  const Mesh mesh = to_graph<Mesh>(soup);
  return checked(mesh, [&](auto ids) { return CGAL::segmentation_via_protrusion_tips(mesh, ids, 2); });
}

// Without the faces around some vertices.
Test_mesh with_holes(Test_mesh mesh, std::uint_fast32_t seed)
{
  constexpr int number_of_holes = 5;
  std::mt19937 random(seed);
  for (int i = 0; i < number_of_holes; ++i)
  {
    const std::size_t middle = mesh.faces[random() % mesh.faces.size()].front();
    const auto is_around = [&](const Face& face) { return std::find(face.begin(), face.end(), middle) != face.end(); };
    mesh.faces.erase(std::remove_if(mesh.faces.begin(), mesh.faces.end(), is_around), mesh.faces.end());
  }
  mesh.parts.clear();
  return mesh;
}

void small_holes_change_no_number()
{
  for (const Test_mesh& mesh : {icosphere(4), dumbbell(), star(5, 2, 0.25, 0.1, 0.2), star(5, 1, 0.2, 0.04, 0.2)})
    for (std::uint_fast32_t seed = 0; seed < 8; ++seed)
      CGAL_CHECK_EQUAL(automatic_segmentation(with_holes(mesh, seed)).number, automatic_segmentation(mesh).number);
}

// Pipes of radius 1 that meet in a fillet: each is a part, the middle is another one. Their ends are cut off at a distance.
Test_mesh junction(const std::vector<Point>& directions, double distance)
{
  constexpr double end_of_fillet = 1.6;
  std::vector<Stick> pipes;
  for (const Point& d : directions)
    pipes.push_back({{0, 0, 0}, (distance + 1) * d, 1, 1, pipes.size() + 1});
  const Test_mesh mesh = implicit_mesh(Implicit_body(pipes, 0.4), 0.25);
  Test_mesh open;
  open.points = mesh.points;
  for (const Face& face : mesh.faces)
  {
    const Point centre = centroid(mesh, face);
    std::size_t part = 0;
    double farthest = end_of_fillet;
    for (std::size_t i = 0; i < directions.size(); ++i)
      if (const double along = dot(centre, directions[i]); along > farthest)
      {
        farthest = along;
        part = i + 1;
      }
    if (farthest < distance)
      open.add_face(face, part);
  }
  return open;
}

void open_pipes_are_parts()
{
  const double s = std::sqrt(0.75);
  const std::vector<Point> tee = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}}, wye = {{1, 0, 0}, {-0.5, s, 0}, {-0.5, -s, 0}},
                           cross = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  for (const auto& directions : {tee, wye, cross})
    for (const double distance : {3.5, 4.5, 6.})
    {
      const Test_mesh mesh = junction(directions, distance);
      check_parts(mesh, automatic_segmentation(mesh), 0.95);
    }
}

// A flat hand: a palm, part 0, with four fingers and a thumb. Its triangles are those of a regular grid in it, turned by an
// angle, so that its outline is a zigzag.
Test_mesh sheet_of_hand(double angle, double edge)
{
  constexpr double height = 2.7, width = 1.7; // of the grid around the middle
  constexpr double radius = 0.14;
  const std::vector<Stick> fingers = {{{-0.55, 0, 0}, {-0.8, 1.3, 0}, radius, radius, 1},
                                      {{-0.18, 0, 0}, {-0.27, 1.4, 0}, radius, radius, 2},
                                      {{0.18, 0, 0}, {0.27, 1.4, 0}, radius, radius, 3},
                                      {{0.55, 0, 0}, {0.8, 1.3, 0}, radius, radius, 4},
                                      {{0.5, -0.6, 0}, {1.5, -0.1, 0}, radius, radius, 5}};
  const auto part_at = [&](const Point& p) -> std::optional<std::size_t>
  {
    if ((std::max)(std::abs(p[0]) / 0.7, std::abs(p[1] + 0.4) / 0.6) < 1)
      return 0;
    for (const Stick& finger : fingers)
      if (finger.distance(p) < 0)
        return finger.part;
    return std::nullopt;
  };
  const Point along = {edge * std::cos(angle), edge * std::sin(angle), 0};
  const Point across = {edge * std::cos(angle + pi / 3), edge * std::sin(angle + pi / 3), 0};
  Test_mesh mesh;
  std::map<std::pair<int, int>, std::size_t> points;
  const auto point = [&](int i, int j)
  {
    const auto [found, is_new] = points.try_emplace({i, j}, points.size());
    if (is_new)
      mesh.add_point(i * along + j * across);
    return found->second;
  };
  const int n = static_cast<int>(2 * (height + width) / edge);
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      for (const int turn : {0, 1}) // the two triangles of a cell
        if (const auto part = part_at((i + (1 + turn) / 3.) * along + (j + (1 + turn) / 3.) * across))
        {
          const std::size_t p = point(i + 1, j), q = point(i, j + 1);
          mesh.add_face(turn ? Face{p, point(i + 1, j + 1), q} : Face{point(i, j), p, q}, *part);
        }
  return mesh;
}

// A zigzag as wide as a third of a finger is no reason to cut it in two.
void sheets_have_zigzag_outlines()
{
  int right = 0;
  for (const double edge : {0.06, 0.07, 0.08})
    for (int degrees = 0; degrees < 60; degrees += 5)
      right += automatic_segmentation(sheet_of_hand(degrees * pi / 180, edge)).number == 6;
  std::cout << right << " of 36 hands have five fingers\n";
  CGAL_CHECK(right >= 30);
}

// Waves of any length in both directions, with slopes of up to 45 degrees.
Test_mesh terrain(std::uint_fast32_t seed)
{
  constexpr std::size_t cells = 60;
  Random random(seed);
  const double along = random.real(4, 20), across = random.real(4, 20), height = random.real(0.2, 1) / (std::max)(along, across);
  return transformed(height_field(cells, cells, seed),
                     [&](const Point& p)
                     {
                       const double x = p[0] / cells, y = p[1] / cells;
                       return Point{x, y, height * std::sin(along * x + 1) * std::sin(across * y)};
                     });
}

void hills_are_no_parts()
{
  int whole = 0;
  for (std::uint_fast32_t seed = 0; seed < 40; ++seed)
    whole += automatic_segmentation(terrain(seed)).number == 1;
  std::cout << whole << " of 40 terrains are whole\n";
  CGAL_CHECK(whole >= 38);
}

} // namespace

int main()
{
  open_pipes_are_parts();
  hills_are_no_parts();
  sheets_have_zigzag_outlines();
  small_holes_change_no_number();
  for (const double height : {1., 1.5, 3., 5.})
    for (const Test_mesh& mesh : {plate_with_peg(height), turned(plate_with_peg(height))})
      check_parts(mesh, segmentation(mesh), 0.95);
  return check::result();
}
