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

// What a page of --report saves. All throw an `Error` that names file and cause.

// The segment with this number, or that of this face
struct Named_segment
{
  std::optional<std::size_t> face, segment;
  std::string name;
};

// {"names": [{"face": 12, "name": "tail"}, {"segment": 3, "name": "left ear"}]}
std::vector<Named_segment> read_names(const std::string& file);

struct Picked_tips
{
  std::vector<std::size_t> faces;
  std::vector<Named_segment> names;
};

// Numbers of faces, and names if there are any: {"tips": [12, 345], "names": [...]}
Picked_tips read_tips(const std::string& file);

// What is in the files of --tips and --names, as far as these are given. Each is read once, since it may be a pipe.
Picked_tips read_tips_and_names(const std::string& tips, const std::string& names);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_READ_TIPS_H
