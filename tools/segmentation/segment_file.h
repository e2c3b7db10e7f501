// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a file to what is found in it, and from that to files.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SEGMENT_FILE_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SEGMENT_FILE_H

#include "segmentation/Findings.h"
#include "segmentation/Recorder.h"

#include <functional>
#include <string>
#include <vector>

namespace tool
{

using Warn = std::function<void(const std::string&)>;

// Throws an `Error` for a file that cannot be read, or has too few faces. `progress` is told of all until the end of
// `write_findings()`; `warn` is called before what may take long.
Findings segment_file(const std::string& input, const Segmentation_options& options,
                      const Recorder::Progress& progress, const Warn& warn);

// What closes the meshes of segments where they were cut off.
enum class Caps
{
  NONE,
  FLAT,  // the same for both sides
  FAIRED // a round one for each side
};

struct Output_names
{
  std::vector<std::string> segments;
  std::string report; // empty: none
  std::string json;   // empty: none
  std::string borders; // empty: none
  Caps caps = Caps::NONE; // of names with a number for each segment
  bool have_numbers = true; // whether a "%d" in one of `segments` stands for that; else it is a name like others
  std::string folder_of_parts = {}; // then, if it is not empty, the closed parts are written there in place of the meshes
};

// Throws an `Error` if one of them cannot be written. Good to know before a long computation.
void check_can_be_written(const Output_names& names);

// Writes all or, with an `Error`, nothing. Notes how long it takes.
void write_findings(Findings& findings, const Output_names& names, const Recorder::Progress& progress = {});

// Empty, or that there are fewer segments than were asked for.
std::string note_on_missing_segments(const Findings& findings);

// "faces, segments, seconds"
std::string summary(const Findings& findings);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SEGMENT_FILE_H
