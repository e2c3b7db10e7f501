// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: the visitor does not derive from Protrusion_segmentation::Segmentation_visitor

#include "mesh.h"

using Other_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>;

std::size_t segment(const Mesh& mesh, Segment_map ids)
{
  Segmentation_visitor<Other_mesh> visitor;
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, CGAL::parameters::visitor(std::ref(visitor)));
}
