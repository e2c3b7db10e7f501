// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: what follows segment_ids must be a number of segments, a method, or both

#include "mesh.h"

std::size_t segment(const Mesh& mesh, Segment_map ids)
{
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, 5, Geodesic_distance(), Histogram_method());
}
