// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: pmesh is no model of FaceListGraph and HalfedgeGraph

#include "mesh.h"

std::size_t segment(const std::vector<Mesh::Point>& points, Segment_map ids)
{
  return CGAL::segmentation_via_protrusion_tips(points, ids, 5);
}
