// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_READ_SOUP_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_READ_SOUP_H

#include "reading/Polygon_soup.h"

#include <string>

namespace tool
{

// The names of the formats that can be read here, in one line; VTP and 3MF are among them only if VTK and lib3mf were
// there at compile time.
std::string known_formats();

// Is the extension one of these, before a ".gz" or not?
bool has_mesh_extension(const std::string& file_name);

// Reads the faces of a file, all and in their order, in the format that the extension of the name says; or throws
// an `Error`. Without an extension, the format is recognized by how the file begins; the name "-" is the standard input.
// Corners exist, and coordinates are finite.
Polygon_soup read_soup(const std::string& file_name);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_READ_SOUP_H
