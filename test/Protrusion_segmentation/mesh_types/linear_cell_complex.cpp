// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_types.h"

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

namespace mesh_types {

void test_linear_cell_complex()
{
  using Traits = CGAL::Linear_cell_complex_traits<3, CGAL::Simple_cartesian<double>>;
  gives_the_same_labels<CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Traits>::type>();
}

} // namespace mesh_types
