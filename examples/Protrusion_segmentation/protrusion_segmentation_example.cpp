// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/IO/SEG.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include "read_or_make_mesh.h"

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// protrusion_segmentation_example [MESH [SEGMENTATION]]
int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!read_or_make_mesh(argc, argv, mesh))
    return EXIT_FAILURE;

  auto segments = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  std::cout << CGAL::segmentation_via_protrusion_tips(mesh, segments) << " segments" << std::endl;

  const bool is_written = argc < 3 || CGAL::IO::write_SEG(argv[2], mesh, segments);
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
