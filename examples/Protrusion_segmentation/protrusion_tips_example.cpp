// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selects protrusion tips, edits them as a user might, and cuts off their protrusions.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/protrusion_segmentation.h>

#include "read_or_make_mesh.h"

#include <iterator>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Face = Mesh::Face_index;

// protrusion_tips_example [MESH]
int main(int argc, char* argv[])
{
  Mesh mesh;
  if (!read_or_make_mesh(argc, argv, mesh))
    return EXIT_FAILURE;

  std::vector<Face> tips;
  CGAL::protrusion_tips(mesh, 6, std::back_inserter(tips));
  std::cout << tips.size() << " tips, at the faces";
  for (const Face tip : tips)
    std::cout << " " << tip.idx();
  std::cout << std::endl;

  tips.pop_back(); // the last one is not wanted

  auto segments = mesh.add_property_map<Face, std::size_t>("f:segment").first;
  const std::size_t number_of_segments = CGAL::segmentation_from_protrusion_tips(mesh, tips, segments);
  std::cout << number_of_segments << " segments from " << tips.size() << " of them" << std::endl;
  return EXIT_SUCCESS;
}
