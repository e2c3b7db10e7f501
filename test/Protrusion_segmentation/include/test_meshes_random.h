// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small random connected triangle meshes for comparisons with brute force.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_RANDOM_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_RANDOM_H

#include "test_meshes_revolution.h"
#include "test_meshes_spheres.h"
#include "test_meshes_transformations.h"

namespace test_meshes {

// Each point moved by up to `distance` along each axis.
inline Test_mesh jittered(const Test_mesh& mesh, double distance, std::uint_fast32_t seed)
{
  Random random(seed);
  return transformed(mesh,
                     [&](Point p)
                     {
                       for (double& coordinate : p)
                         coordinate += random.real(-distance, distance);
                       return p;
                     });
}

// A sphere with a few bumps out and dents in.
inline Test_mesh bumpy_sphere(std::size_t levels, std::uint_fast32_t seed)
{
  Random random(seed);
  std::vector<std::pair<Point, double>> bumps;
  for (int i = 0; i < 6; ++i)
  {
    const Point p = {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    bumps.push_back({(1 / length(p)) * p, random.real(-0.4, 1)});
  }
  return transformed(icosphere(levels),
                     [&](const Point& p)
                     {
                       double radius = 1;
                       for (const auto& bump : bumps)
                         radius += bump.second * std::exp(-8 * dot(p - bump.first, p - bump.first));
                       return radius * p;
                     });
}

// An open height field: cells of a sheet cut along a random diagonal each.
inline Test_mesh height_field(std::size_t columns, std::size_t rows, std::uint_fast32_t seed)
{
  Random random(seed);
  Test_mesh mesh;
  for (std::size_t y = 0; y <= rows; ++y)
    for (std::size_t x = 0; x <= columns; ++x)
      mesh.add_point(
        {double(x) + random.real(-0.3, 0.3), double(y) + random.real(-0.3, 0.3), random.real(0, 1)});
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < columns; ++x)
    {
      const std::size_t a = y * (columns + 1) + x, b = a + 1, d = a + columns + 1, c = d + 1;
      const bool falling = random.index(2) == 0;
      mesh.add_face(falling ? Face{a, b, d} : Face{a, b, c});
      mesh.add_face(falling ? Face{b, c, d} : Face{a, c, d});
    }
  return mesh;
}

// One of several kinds of surfaces (bumpy sphere, jittered sphere, height field with borders,
// jittered torus), with 40 to 320 triangles in random order. The same seed gives the same mesh.
inline Test_mesh random_surface(std::uint_fast32_t seed)
{
  Random random(seed);
  const std::uint_fast32_t inner_seed = 1000 + seed;
  const std::size_t kind = random.index(4);
  const std::size_t m = 5 + random.index(7); // not inside the calls: arguments have no fixed order
  const std::size_t n = 4 + random.index(6);
  Test_mesh mesh;
  switch (kind)
  {
  case 0:
    mesh = bumpy_sphere(1 + m % 2, inner_seed);
    break;
  case 1:
    mesh = jittered(icosphere(1 + m % 2), 0.08, inner_seed);
    break;
  case 2:
    mesh = height_field(m, n, inner_seed);
    break;
  default:
    mesh = jittered(triangulated(torus(2, 0.8, m, n)), 0.1, inner_seed);
  }
  return with_face_order(mesh, random_permutation(mesh.faces.size(), inner_seed));
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_RANDOM_H
