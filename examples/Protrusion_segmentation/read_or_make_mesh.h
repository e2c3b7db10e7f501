// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mesh of the examples: the file that is named on the command line, else the elephant of CGAL's data folder,
// else, where that folder is not installed, a ball with six arms.

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_READ_OR_MAKE_MESH_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_READ_OR_MAKE_MESH_H

#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <iostream>
#include <string>

template <typename Surface_mesh>
void make_ball_with_arms(Surface_mesh& mesh)
{
  using Point = typename Surface_mesh::Point;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
  for (const auto v : vertices(mesh))
  {
    auto normal = mesh.point(v) - CGAL::ORIGIN;
    normal = normal / std::sqrt(normal.squared_length());
    const double height = std::pow(normal.x(), 32) + std::pow(normal.y(), 32) + std::pow(normal.z(), 32);
    mesh.point(v) = CGAL::ORIGIN + (1 + 4 * height) * normal;
  }
}

template <typename Surface_mesh>
bool read_or_make_mesh(int argc, char* argv[], Surface_mesh& mesh)
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  if (CGAL::IO::read_polygon_mesh(file, mesh))
    return true;
  if (argc > 1)
  {
    std::cerr << file << " is no mesh that can be read" << std::endl;
    return false;
  }
  std::cerr << "A ball with six arms takes its place." << std::endl;
  mesh.clear();
  make_ball_with_arms(mesh);
  return true;
}

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_READ_OR_MAKE_MESH_H
