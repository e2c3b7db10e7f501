// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sheets that are cut out of a plane, with the true part of every face, and plates of the same outlines.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_FLAT_SHAPES_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_FLAT_SHAPES_H

#include "test_meshes.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace test_meshes {

constexpr int outside = -1;

// The cells of a grid over [-1, 1] x [-1, 1], each as two triangles, for whose centre `part(x, y)` is not `outside`. Vertices
// are moved by up to a tenth of an edge, so that outlines are ragged.
template <typename Part>
Test_mesh flat_shape(Part part, int cells = 90)
{
  std::mt19937 random(5);
  const double size = 2. / cells;
  const auto moved = [&](int i) { return size * (i + 0.2 * (random() / 4294967296. - 0.5)) - 1; };
  Test_mesh mesh;
  std::map<std::pair<int, int>, std::size_t> numbers;
  const auto point = [&](int i, int j)
  {
    const auto [position, is_new] = numbers.emplace(std::make_pair(i, j), mesh.points.size());
    if (is_new)
    {
      const double x = moved(i), y = moved(j);
      mesh.add_point({x, y, 0});
    }
    return position->second;
  };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      if (const int p = part((i + 0.5) * size - 1, (j + 0.5) * size - 1); p != outside)
      {
        const std::size_t a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1),
                          d = point(i, j + 1);
        mesh.add_face({a, b, (i + j) % 2 == 0 ? c : d}, std::size_t(p));
        mesh.add_face({(i + j) % 2 == 0 ? a : b, c, d}, std::size_t(p));
      }
  return mesh;
}

// A disk with arms around it, each a part. `half_width(r)`: of an arm at the distance r from the centre; `turned`: by how many arms
template <typename HalfWidth>
Test_mesh star_with_arms(int arms, int cells, double disk, double turned, HalfWidth half_width)
{
  return flat_shape(
    [=](double x, double y)
    {
      constexpr double reach = 0.95;
      const double r = std::hypot(x, y), turn = std::atan2(y, x) * arms / (2 * pi) + arms + turned; // in arms
      const double nearest = std::round(turn), angle = (turn - nearest) * 2 * pi / arms;
      if (r < disk)
        return 0;
      return r < reach && std::abs(r * std::sin(angle)) < half_width(r) && std::abs(angle) < pi / arms
               ? 1 + int(nearest) % arms
               : outside;
    },
    cells);
}

inline Test_mesh flat_star(int arms, int cells)
{
  return star_with_arms(arms, cells, 0.35, 0, [](double) { return 0.12; });
}

inline Test_mesh flat_dumbbell()
{
  return flat_shape(
    [](double x, double y)
    {
      if (std::hypot(std::abs(x) - 0.6, y) < 0.33)
        return x < 0 ? 1 : 2;
      return std::abs(y) < 0.1 && std::abs(x) < 0.6 ? 0 : outside;
    });
}

inline Test_mesh star_with_tapering_arms(int arms, int cells, double turned)
{
  return star_with_arms(arms, cells, 0.4, turned, [](double r) { return 0.17 - 0.11 * (r - 0.4) / 0.55; });
}

// A figure with a head, arms and legs, whose parts are not alike.
inline Test_mesh flat_figure(int cells)
{
  return flat_shape(
    [](double x, double y)
    {
      if (std::hypot(x, y - 0.62) < 0.22)
        return 1;
      if (std::abs(x) < 0.24 && y > -0.2 && y < 0.45)
        return 0;
      if (y > 0.2 && y < 0.36 && std::abs(x) < 0.9)
        return x < 0 ? 2 : 3;
      return std::abs(std::abs(x) - 0.13) < 0.1 && y > -0.95 && y <= -0.2 ? (x < 0 ? 4 : 5) : outside;
    },
    cells);
}

// The plate with the given sheet in the middle; its walls have the parts of the faces beside them.
inline Test_mesh thickened(const Test_mesh& sheet, double thickness)
{
  Test_mesh result;
  for (const double z : {-thickness / 2, thickness / 2})
    for (const Point& p : sheet.points)
      result.add_point({p[0], p[1], p[2] + z});
  const std::size_t n = sheet.points.size();
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> part_beside; // edges
  for (std::size_t f = 0; f < sheet.faces.size(); ++f)
  {
    const Face& face = sheet.faces[f];
    Face above = face;
    for (std::size_t& v : above)
      v += n;
    result.add_face(Face(face.rbegin(), face.rend()), sheet.parts[f]);
    result.add_face(above, sheet.parts[f]);
    for (std::size_t i = 0; i < face.size(); ++i)
      part_beside[{face[i], face[(i + 1) % face.size()]}] = sheet.parts[f];
  }
  for (const auto& [edge, part] : part_beside)
    if (const auto [a, b] = edge; part_beside.count({b, a}) == 0)
    {
      result.add_face({a, b, b + n}, part);
      result.add_face({a, b + n, a + n}, part);
    }
  return result;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_FLAT_SHAPES_H
