// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: edge_is_constrained_map is no writable property map from the edges of the mesh to bool

#include "mesh.h"

std::size_t segment(const Mesh& mesh, Segment_map ids)
{
  std::vector<bool> is_border(mesh.number_of_edges());
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, CGAL::parameters::edge_is_constrained_map(is_border));
}
