// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/protrusion_segmentation.h>

#include <cstddef>
#include <iostream>

int main()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;

  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  auto segments = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t number_of_segments = CGAL::segmentation_via_protrusion_tips(mesh, segments, 1);
  std::cout << number_of_segments << " segment" << std::endl;
  return number_of_segments == 1 ? 0 : 1;
}
