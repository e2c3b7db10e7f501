// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_REMESH_H
#define PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_REMESH_H

#include "example_meshes/Shape.h"
#include "reading/Mesh.h"

namespace example_shapes
{

// Turns a closed mesh of the surface of `shape`, with triangles that are smaller, into one of nearly
// equilateral triangles with edges of about the length `edge`.
void remesh(tool::Mesh& mesh, const Shape& shape, double edge);

} // namespace example_shapes

#endif // PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_REMESH_H
