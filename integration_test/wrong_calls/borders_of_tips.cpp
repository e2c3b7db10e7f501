// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: edge_is_constrained_map has no meaning here

#include "mesh.h"

std::size_t select(const Mesh& mesh, Mesh::Property_map<Mesh::Edge_index, bool> is_border)
{
  std::vector<Mesh::Face_index> tips;
  CGAL::protrusion_tips(mesh, 5, std::back_inserter(tips), CGAL::parameters::edge_is_constrained_map(is_border));
  return tips.size();
}
