// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sphere and what is like one, made by a formula.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SPHERE_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SPHERE_H

#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>

// Of 20 * 4^subdivisions faces; `radius(direction)` is that in the direction of a vector of length 1.
template <typename Mesh, typename Radius>
Mesh sphere(unsigned subdivisions, Radius radius)
{
  using Point = typename Mesh::Point;
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(subdivisions));
  for (const auto v : vertices(mesh))
  {
    const auto from_center = mesh.point(v) - CGAL::ORIGIN;
    const auto direction = from_center / std::sqrt(from_center.squared_length());
    mesh.point(v) = CGAL::ORIGIN + radius(direction) * direction;
  }
  return mesh;
}

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SPHERE_H
