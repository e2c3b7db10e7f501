// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: override

#include "mesh.h"

struct Visitor : Segmentation_visitor<Mesh>
{
  bool go_furhter() override { return false; }
};

std::size_t segment(const Mesh& mesh, Segment_map ids)
{
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, CGAL::parameters::visitor(Visitor()));
}
