// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: segment_ids is no writable property map from the faces of the mesh to an integer type

#include "mesh.h"

void segment(const Mesh& mesh, const Segment_hierarchy& hierarchy, Mesh::Property_map<Mesh::Face_index, double> ids)
{
  hierarchy.segment_ids(mesh, 5, ids);
}
