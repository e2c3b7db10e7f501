// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: edge_is_constrained_map has no meaning here

#include "mesh.h"

std::size_t segment(const Mesh& mesh, Mesh::Property_map<Mesh::Edge_index, bool> is_border)
{
  return CGAL::protrusion_hierarchy(mesh, 5, CGAL::parameters::edge_is_constrained_map(is_border))
    .maximum_number_of_segments();
}
