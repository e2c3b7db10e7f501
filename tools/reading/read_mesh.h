// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading meshes of any format, whatever is wrong with their faces.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_READ_MESH_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_READ_MESH_H

#include "command_line/Error.h"
#include "reading/Mesh.h"
#include "reading/read_soup.h"
#include "repair/Input_mesh.h"

#include <optional>
#include <string>

namespace tool
{

// Reads the faces of a file and makes a surface of them, with the tolerance of `make_input_mesh()`; or throws an `Error`.
Input_mesh read_input_mesh(const std::string& file_name, std::optional<double> tolerance = std::nullopt);

// The same with the pieces of the file joined. A gap out of range is an `Error`, too.
Input_mesh read_joined_pieces(const std::string& file_name, std::optional<double> gap);

// The surface alone. Its faces are those of the file, in their order, without degenerate and duplicate ones.
Mesh read_mesh(const std::string& file_name);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_READ_MESH_H
