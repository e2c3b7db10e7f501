// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two translation units that include all public headers link: no function is defined twice.

#include "check.h"
#include "all_public_headers.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

std::size_t number_of_segments_in_second_unit();

int main()
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  CGAL::make_icosahedron(mesh, CGAL::Simple_cartesian<double>::Point_3(0, 0, 0));
  auto ids = mesh.add_property_map<CGAL::SM_Face_index, std::size_t>("f:segment", 0).first;
  CGAL_CHECK_EQUAL(CGAL::segmentation_via_protrusion_tips(mesh, ids, 1), 1);
  CGAL_CHECK_EQUAL(number_of_segments_in_second_unit(), 1);
  return check::result();
}
