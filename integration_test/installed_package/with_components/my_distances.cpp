// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/protrusion_segmentation.h>

#include <cstddef>
#include <iostream>

#ifndef CGAL_LINKED_WITH_TBB
#error "The component TBB does not tell CGAL of TBB"
#endif

int main()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  namespace PS = CGAL::Protrusion_segmentation;

  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  auto segments = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t number_by_heat = CGAL::segmentation_via_protrusion_tips(
      mesh, segments, 1, PS::Histogram_method(PS::Heat_distance()));
  const std::size_t number_by_diffusion = CGAL::segmentation_via_protrusion_tips<CGAL::Parallel_tag>(
      mesh, segments, 1, PS::Histogram_method(PS::Diffusion_distance(3)));
  std::cout << number_by_heat << " and " << number_by_diffusion << " segments" << std::endl;
  return number_by_heat == 1 && number_by_diffusion == 1 ? 0 : 1;
}
