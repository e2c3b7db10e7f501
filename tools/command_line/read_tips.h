// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_READ_TIPS_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_READ_TIPS_H

#include <cstddef>
#include <string>
#include <vector>

namespace tool
{

// Numbers of faces: a file as the report saves it, {"tips": [12, 345]}. Throws an `Error` that names file and cause.
std::vector<std::size_t> read_tips(const std::string& file);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_READ_TIPS_H
