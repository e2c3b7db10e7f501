// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_READ_TIPS_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_READ_TIPS_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tool
{

// What a page of --report saves. Both throw an `Error` that names file and cause.

// Numbers of faces: {"tips": [12, 345]}
std::vector<std::size_t> read_tips(const std::string& file);

// The segment with this number, or that of this face
struct Named_segment
{
  std::optional<std::size_t> face, segment;
  std::string name;
};

// None if there is no such array: {"names": [{"face": 12, "name": "tail"}, {"segment": 3, "name": "left ear"}]}
std::vector<Named_segment> read_names(const std::string& file);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_READ_TIPS_H
