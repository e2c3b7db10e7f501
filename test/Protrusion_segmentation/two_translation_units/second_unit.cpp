// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "all_public_headers.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

std::size_t number_of_segments_in_second_unit()
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  CGAL::make_tetrahedron(CGAL::Simple_cartesian<double>::Point_3(0, 0, 0), {1, 0, 0}, {0, 1, 0},
                         {0, 0, 1}, mesh);
  auto ids = mesh.add_property_map<CGAL::SM_Face_index, std::size_t>("f:segment", 0).first;
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, 1);
}
