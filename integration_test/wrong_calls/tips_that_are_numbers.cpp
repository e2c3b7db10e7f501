// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: tips is no range of faces of the mesh

#include "mesh.h"

std::size_t segment(const Mesh& mesh, Segment_map ids)
{
  return CGAL::segmentation_from_protrusion_tips(mesh, std::vector<int>{1, 2}, ids);
}
