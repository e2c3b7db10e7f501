// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_WRITE_MESH_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_WRITE_MESH_H

#include "reading/Mesh.h"

#include <string>

namespace tool
{

// Has the name the extension of a format?
bool can_write_mesh(const std::string& file_name);

// Writes a mesh in the format that the extension of the name says, which there is; or throws an `Error`.
void write_mesh(const std::string& file_name, const Mesh& mesh);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_WRITE_MESH_H
