// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: the visitor is no model of ProtrusionSegmentationVisitor

#include "mesh.h"

#include <CGAL/Polyhedron_3.h>

using Other_mesh = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;

std::size_t segment(const Mesh& mesh, Segment_map ids)
{
  Segmentation_visitor<Other_mesh> visitor;
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, CGAL::parameters::visitor(std::ref(visitor)));
}
