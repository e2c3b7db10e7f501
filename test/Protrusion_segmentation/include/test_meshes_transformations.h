// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Transformations of test meshes, all of which keep every face's true part, and random numbers
// that are the same with every standard library.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_TRANSFORMATIONS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_TRANSFORMATIONS_H

#include "test_mesh.h"

#include <cmath>
#include <random>

namespace test_meshes {

// The standard fixes the numbers of std::mt19937, but not those of its distributions.
class Random
{
public:
  explicit Random(std::uint_fast32_t seed) : m_generator(seed) {}

  // In [from, to).
  double real(double from, double to)
  {
    return from + (to - from) * (double(m_generator()) / 4294967296.);
  }

  // In [0, bound); hardly biased, as test meshes are small.
  std::size_t index(std::size_t bound) { return m_generator() % bound; }

private:
  std::mt19937 m_generator;
};

// `function`: Point -> Point.
template <typename Function>
Test_mesh transformed(Test_mesh mesh, Function function)
{
  std::transform(mesh.points.begin(), mesh.points.end(), mesh.points.begin(), function);
  return mesh;
}

// Sines and cosines may differ in their last digit; fewer digits hide that. (Floats would not do: g++ 12 with
// -O3 leaves the conversion to float and back out.)
inline Test_mesh with_rounded_points(const Test_mesh& mesh)
{
  const auto round = [](double x) { return std::ldexp(std::round(std::ldexp(x, 24)), -24); };
  return transformed(mesh,
                     [round](const Point& p) { return Point{round(p[0]), round(p[1]), round(p[2])}; });
}

inline Test_mesh translated(const Test_mesh& mesh, const Point& vector)
{
  return transformed(mesh, [&](const Point& p) { return p + vector; });
}

inline Test_mesh scaled(const Test_mesh& mesh, double x, double y, double z)
{
  return transformed(mesh, [&](const Point& p) { return Point{x * p[0], y * p[1], z * p[2]}; });
}

inline Test_mesh scaled(const Test_mesh& mesh, double factor)
{
  return scaled(mesh, factor, factor, factor);
}

// Around an axis through the origin, by an angle in radians, counterclockwise seen against it.
inline Test_mesh rotated(const Test_mesh& mesh, const Point& axis, double angle)
{
  const Point a = (1 / length(axis)) * axis;
  const double c = std::cos(angle), s = std::sin(angle);
  return transformed(mesh,
                     [&](const Point& p) { return c * p + s * cross(a, p) + ((1 - c) * dot(a, p)) * a; });
}

// A permutation of 0 .. n-1.
inline std::vector<std::size_t> random_permutation(std::size_t n, std::uint_fast32_t seed)
{
  Random random(seed);
  std::vector<std::size_t> result(n);
  std::iota(result.begin(), result.end(), std::size_t(0));
  for (std::size_t i = n; i > 1; --i)
    std::swap(result[i - 1], result[random.index(i)]);
  return result;
}

// Face i of the result is face `order[i]` of `mesh`; the points stay as they are.
inline Test_mesh with_face_order(const Test_mesh& mesh, const std::vector<std::size_t>& order)
{
  Test_mesh result;
  result.points = mesh.points;
  for (std::size_t f : order)
    result.add_face(mesh.faces.at(f), mesh.parts.at(f));
  return result;
}

// Every face with points of its own, as in STL.
inline Test_mesh exploded(const Test_mesh& mesh)
{
  Test_mesh result;
  for (const Face& face : mesh.faces)
  {
    Face own;
    for (const std::size_t v : face)
      own.push_back(result.add_point(mesh.points[v]));
    result.add_face(own);
  }
  return result;
}

inline Test_mesh with_reversed_orientation(Test_mesh mesh)
{
  for (Face& face : mesh.faces)
    std::reverse(face.begin(), face.end());
  return mesh;
}

// Every face cut into triangles from its first point (right for convex faces); the triangles of
// face 0 come first, then those of face 1, and so on; parts are kept.
inline Test_mesh triangulated(const Test_mesh& mesh)
{
  Test_mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const Face& face = mesh.faces[f];
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      result.add_face({face[0], face[i], face[i + 1]}, mesh.parts[f]);
  }
  return result;
}

// All meshes in one, in their order, the parts of each numbered on from those before.
inline Test_mesh merged(const std::vector<Test_mesh>& meshes)
{
  Test_mesh result;
  for (const Test_mesh& mesh : meshes)
  {
    const std::size_t first_point = result.points.size(), first_part = number_of_parts(result);
    result.points.insert(result.points.end(), mesh.points.begin(), mesh.points.end());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
      Face face = mesh.faces[f];
      for (std::size_t& v : face)
        v += first_point;
      result.add_face(std::move(face), first_part + mesh.parts[f]);
    }
  }
  return result;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_TRANSFORMATIONS_H
