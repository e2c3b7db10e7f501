// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// protrusion_tips_example MESH SEGMENTATION
//
// Selects protrusion tips, edits them as a user might, and cuts off their protrusions.

#include <CGAL/IO/SEG.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/protrusion_segmentation.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Face = Mesh::Face_index;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "protrusion_tips_example: needs a mesh and the name of a .seg file" << std::endl;
    return EXIT_FAILURE;
  }

  try
  {
    std::vector<Face> tips;
    CGAL::protrusion_tips(mesh, 6, std::back_inserter(tips));
    std::cout << tips.size() << " tips, at the faces";
    for (const Face tip : tips)
      std::cout << " " << tip.idx();

    tips.pop_back(); // the last one is not wanted

    auto segments = mesh.add_property_map<Face, std::size_t>("f:segment").first;
    std::cout << "\n"
              << CGAL::segmentation_from_protrusion_tips(mesh, tips, segments) << " segments from "
              << tips.size() << " of them" << std::endl;
    return CGAL::IO::write_SEG(argv[2], mesh, segments) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << "protrusion_tips_example: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
