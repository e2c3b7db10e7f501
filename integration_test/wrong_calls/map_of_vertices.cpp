// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: segment_ids is no writable property map from the faces of the mesh to an integer type

#include "mesh.h"

std::size_t segment(const Mesh& mesh, Mesh::Property_map<Mesh::Vertex_index, std::size_t> ids)
{
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, 5, Histogram_method());
}
