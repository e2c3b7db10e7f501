// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading meshes of any format that CGAL reads, with the cause of a failure.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_READ_MESH_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_READ_MESH_H

#include "command_line/Error.h"
#include "reading/Mesh.h"

#include <string>
#include <vector>

namespace tool
{

// The extensions of the formats that CGAL reads; VTP is one only if VTK was there at compile time.
std::vector<std::string> mesh_extensions();

// Their names in one line.
std::string known_formats();

// Reads a mesh of any format that CGAL reads, chosen by the extension of the name; or throws an
// `Error`. Faces are in the order of the file, all of them. Border edges that lie on each other are
// joined, as of faces that share no vertices.
Mesh read_mesh(const std::string& file_name);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_READ_MESH_H
