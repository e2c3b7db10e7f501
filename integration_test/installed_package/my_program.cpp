// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/IO/SEG.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

int main(int argc, char* argv[])
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  if (argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return EXIT_FAILURE; // usage: my_program MESH SEGMENTS
  auto segments = mesh.add_property_map<CGAL::SM_Face_index, std::size_t>("f:segment").first;
  std::cout << CGAL::segmentation_via_protrusion_tips(mesh, segments) << " segments\n";
  return CGAL::IO::write_SEG(argv[2], mesh, segments) ? EXIT_SUCCESS : EXIT_FAILURE;
}
