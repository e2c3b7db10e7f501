// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: segment_ids is no writable property map from the faces of the mesh to an integer type

#include "mesh.h"

std::size_t segment(const Mesh& mesh,
                    const std::vector<Mesh::Face_index>& tips,
                    Mesh::Property_map<Mesh::Face_index, Mesh::Point> ids)
{
  return CGAL::segmentation_from_protrusion_tips(mesh, tips, ids);
}
