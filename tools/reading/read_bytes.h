// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_READ_BYTES_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_READ_BYTES_H

#include <string>

namespace tool
{

// All bytes of a file, a pipe or, as "-", of the standard input, decompressed if they are gzip; or throws
// an `Error`. What is there is read once, and no byte order mark is left.
std::string read_bytes(const std::string& file_name);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_READ_BYTES_H
