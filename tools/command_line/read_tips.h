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

// The name of the segment with this number, or of that of this face
struct Named_segment
{
  std::optional<std::size_t> face, segment;
  std::string name;
};

struct Picked_tips
{
  std::optional<std::vector<std::size_t>> faces; // none without --tips
  std::vector<Named_segment> names;
  std::string file_of_names;
};

// What a page of --report saves, in the files of --tips and --names, as far as these are given:
// {"tips": [12, 345], "names": [{"face": 12, "name": "tail"}, {"segment": 3, "name": "left ear"}]}. With tips, names may be left out.
// Each file is read once, since it may be a pipe. Throws an `Error` that names file and cause.
Picked_tips read_tips_and_names(const std::string& tips, const std::string& names);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_READ_TIPS_H
