// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: the visitor is no model of ProtrusionSegmentationVisitor

#include "mesh.h"

struct Visitor
{
  bool go_further() { return true; }
};

std::size_t segment(const Mesh& mesh, Segment_map ids)
{
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, CGAL::parameters::visitor(Visitor()));
}
