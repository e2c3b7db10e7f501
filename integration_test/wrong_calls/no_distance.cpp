// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: the distance is no model of ProtrusionDistance

#include "mesh.h"

std::size_t segment(const Mesh& mesh, Segment_map ids)
{
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, 5, Histogram_method(0.05));
}
