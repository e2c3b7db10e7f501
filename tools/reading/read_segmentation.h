// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_READ_SEGMENTATION_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_READ_SEGMENTATION_H

#include "reading/Mesh.h"
#include "repair/Input_mesh.h"

#include <cstddef>
#include <string>

namespace tool
{

using Segment_ids = Mesh::Property_map<Face, std::size_t>;

// Reads a `.seg` file, with an id for each face of the mesh's file, into a new property map of the mesh; or
// throws an `Error`.
Segment_ids read_segmentation(const std::string& file_name, Input_mesh& input);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_READ_SEGMENTATION_H
