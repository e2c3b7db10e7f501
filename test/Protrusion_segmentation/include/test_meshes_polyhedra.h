// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes, bodies of cubes, prisms, sheets and strips: analytic areas, quads and n-gons, thin faces.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_POLYHEDRA_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_POLYHEDRA_H

#include "test_mesh.h"
#include "test_meshes_transformations.h"

namespace test_meshes {

// One triangle with sides 1, 1, sqrt(2).
inline Test_mesh single_triangle()
{
  Test_mesh result;
  result.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  result.add_face({0, 1, 2});
  return result;
}

// The regular tetrahedron with edge length 2 sqrt(2).
inline Test_mesh tetrahedron()
{
  Test_mesh result;
  result.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const Face& face : {Face{0, 1, 2}, Face{0, 2, 3}, Face{0, 3, 1}, Face{1, 3, 2}})
    result.add_face(face);
  return result;
}

// unit cubes, given by their lowest corners
using Cubes = std::set<std::array<int, 3>>;

// Those from `first` to before `last` in each direction.
inline void add_cubes(Cubes& cubes, const std::array<int, 3>& first, const std::array<int, 3>& last)
{
  for (int x = first[0]; x < last[0]; ++x)
    for (int y = first[1]; y < last[1]; ++y)
      for (int z = first[2]; z < last[2]; ++z)
        cubes.insert({x, y, z});
}

// The surface of a union of cubes in quads. It is manifold
// unless two of the cubes touch in an edge or a corner alone. Part: the side that a face looks to,
// 0 and 1 for -x and +x, 2 and 3 for y, 4 and 5 for z.
inline Test_mesh voxels(const Cubes& cubes)
{
  Test_mesh result;
  std::map<std::array<int, 3>, std::size_t> vertices;
  auto vertex = [&](const std::array<int, 3>& p)
  {
    const auto found = vertices.emplace(p, result.points.size());
    if (found.second)
      result.add_point({double(p[0]), double(p[1]), double(p[2])});
    return found.first->second;
  };

  for (const std::array<int, 3>& cube : cubes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int side : {0, 1})
      {
        std::array<int, 3> neighbor = cube, p = cube;
        neighbor[axis] += 2 * side - 1;
        if (cubes.count(neighbor) != 0)
          continue;
        // Around the next axis and the one after it: counterclockwise seen from +axis.
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        p[axis] += side;
        Face face = {vertex(p)};
        ++p[u];
        face.push_back(vertex(p));
        ++p[v];
        face.push_back(vertex(p));
        --p[u];
        face.push_back(vertex(p));
        if (side == 0)
          std::reverse(face.begin(), face.end());
        result.add_face(std::move(face), 2 * axis + static_cast<std::size_t>(side));
      }
  return result;
}

// A box of nx * ny * nz unit cubes: 2 (nx ny + ny nz + nz nx) quads. Parts: the six sides.
inline Test_mesh box(int nx = 1, int ny = 1, int nz = 1)
{
  Cubes cubes;
  add_cubes(cubes, {0, 0, 0}, {nx, ny, nz});
  return voxels(cubes);
}

// A plate of (2 nx + 1) * (2 ny + 1) unit cubes with nx * ny square holes: genus nx * ny.
inline Test_mesh pierced_plate(int nx, int ny)
{
  Cubes cubes;
  for (int x = 0; x < 2 * nx + 1; ++x)
    for (int y = 0; y < 2 * ny + 1; ++y)
      if (x % 2 == 0 || y % 2 == 0)
        cubes.insert({x, y, 0});
  return voxels(cubes);
}

// A flat open sheet of columns * rows rectangles in the plane z = 0, seen from +z. One part.
inline Test_mesh sheet(std::size_t columns, std::size_t rows, double width = 1, double height = 1)
{
  Test_mesh result;
  for (std::size_t y = 0; y <= rows; ++y)
    for (std::size_t x = 0; x <= columns; ++x)
      result.add_point({width * double(x), height * double(y), 0});
  const std::size_t next_row = columns + 1;
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < columns; ++x)
    {
      const std::size_t v = y * next_row + x;
      result.add_face({v, v + 1, v + 1 + next_row, v + next_row});
    }
  return result;
}

// An open strip of 2 n triangles, each `1` long and `width` wide. One part.
inline Test_mesh thin_strip(std::size_t n, double width = 1e-3)
{
  return triangulated(sheet(n, 1, 1., width));
}

// A Moebius strip of n quads, n >= 3: no orientation of its faces is consistent, hence no
// halfedge-based mesh type holds it as it is (`convert()` throws). One part.
inline Test_mesh moebius_strip(std::size_t n = 24)
{
  Test_mesh result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double turn = 2 * pi * double(i) / double(n);
    for (double side : {-0.3, 0.3})
    {
      const double r = 1 + side * std::cos(turn / 2);
      result.add_point({r * std::cos(turn), r * std::sin(turn), side * std::sin(turn / 2)});
    }
  }
  for (std::size_t i = 0; i + 1 < n; ++i)
    result.add_face({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  result.add_face({2 * n - 2, 1, 0, 2 * n - 1});
  return result;
}

// A prism of the given height over a simple polygon in counterclockwise order, convex or not.
// Parts: 0 the walls, 1 the bottom, 2 the top.
inline Test_mesh prism(const std::vector<std::array<double, 2>>& polygon, double height)
{
  Test_mesh result;
  const std::size_t n = polygon.size();
  for (double z : {0., height})
    for (const std::array<double, 2>& p : polygon)
      result.add_point({p[0], p[1], z});
  Face bottom, top;
  for (std::size_t i = 0; i < n; ++i)
  {
    result.add_face({i, (i + 1) % n, (i + 1) % n + n, i + n}, 0);
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
  }
  result.add_face(bottom, 1);
  result.add_face(top, 2);
  return result;
}

// A prism over a regular polygon with n sides and the given circumradius.
inline Test_mesh regular_prism(std::size_t n, double radius = 1, double height = 1)
{
  std::vector<std::array<double, 2>> polygon;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double turn = 2 * pi * double(i) / double(n);
    polygon.push_back({radius * std::cos(turn), radius * std::sin(turn)});
  }
  return prism(polygon, height);
}

// A prism over an L: two non-convex hexagons and six quads.
inline Test_mesh l_prism()
{
  return prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);
}

// A ring from `bore` to 1 with teeth up to `reach`, which are as wide as the gaps. Parts: 0 the ring, 1 + i the i-th tooth.
inline Test_mesh gear(std::size_t teeth, double bore, double reach, double height)
{
  constexpr std::size_t points_of_tooth = 3;
  const std::size_t steps = 2 * points_of_tooth * teeth;
  Test_mesh mesh;
  const auto add_circle = [&](double r, double z)
  {
    const std::size_t first = mesh.points.size();
    for (std::size_t i = 0; i < steps; ++i)
      mesh.add_point({r * std::cos(2 * pi * double(i) / double(steps)), r * std::sin(2 * pi * double(i) / double(steps)), z});
    return first;
  };
  const std::size_t bore_below = add_circle(bore, 0), bore_above = add_circle(bore, height);
  const std::size_t below = add_circle(1, 0), above = add_circle(1, height);
  const std::size_t tip_below = add_circle(reach, 0), tip_above = add_circle(reach, height);
  for (std::size_t i = 0; i < steps; ++i)
  {
    const std::size_t j = (i + 1) % steps, along = i % (2 * points_of_tooth), tooth = 1 + i / (2 * points_of_tooth);
    mesh.add_face({bore_above + i, above + i, above + j, bore_above + j});
    mesh.add_face({bore_below + j, below + j, below + i, bore_below + i});
    mesh.add_face({bore_below + i, bore_above + i, bore_above + j, bore_below + j});
    if (along >= points_of_tooth)
    {
      mesh.add_face({below + i, below + j, above + j, above + i});
      continue;
    }
    mesh.add_face({above + i, tip_above + i, tip_above + j, above + j}, tooth);
    mesh.add_face({below + j, tip_below + j, tip_below + i, below + i}, tooth);
    mesh.add_face({tip_below + i, tip_below + j, tip_above + j, tip_above + i}, tooth);
    if (along == 0)
      mesh.add_face({below + i, tip_below + i, tip_above + i, above + i}, tooth);
    if (along == points_of_tooth - 1)
      mesh.add_face({below + j, above + j, tip_above + j, tip_below + j}, tooth);
  }
  return mesh;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_POLYHEDRA_H
