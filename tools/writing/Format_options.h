// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_FORMAT_OPTIONS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_FORMAT_OPTIONS_H

#include <string>

namespace tool {

// What can be chosen about files of meshes.
struct Format_options
{
  bool are_faces_triangulated = false;
  bool is_one_object = false;         // of glTF: one mesh of many primitives, or a node for each segment
  std::string up = "y";               // the axis of the mesh that points up, "y" or "z"
  bool are_colors_of_input = false; // vertex colours and materials, in place of those of segments
  std::string array_name = "segment"; // in VTP
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_FORMAT_OPTIONS_H
