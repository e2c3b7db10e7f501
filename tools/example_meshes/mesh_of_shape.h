// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_MESH_OF_SHAPE_H
#define PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_MESH_OF_SHAPE_H

#include "example_meshes/Shape.h"
#include "reading/Mesh.h"

#include <cstddef>

namespace example_shapes
{

// A closed mesh of nearly equilateral triangles, at least `number_of_faces` and up to a quarter
// more. The same on every machine but for the last digits of coordinates.
tool::Mesh mesh_of_shape(const Shape& shape, std::size_t number_of_faces);

} // namespace example_shapes

#endif // PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_MESH_OF_SHAPE_H
