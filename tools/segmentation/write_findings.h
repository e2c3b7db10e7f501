// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_WRITE_FINDINGS_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_WRITE_FINDINGS_H

#include "segmentation/Findings.h"
#include "segmentation/Recorder.h"

#include <string>
#include <vector>

namespace tool
{

// What closes the meshes of segments where they were cut off.
enum class Caps
{
  NONE,
  FLAT,  // the same for both sides
  FAIRED, // a round one for each side
  HULL // the convex hull of each, in its place
};

struct Output_names
{
  std::vector<std::string> segments;
  std::string report; // empty: none
  std::string json;   // empty: none
  std::string borders; // empty: none
  std::string skeleton; // empty: none
  std::string rig; // empty: none
  Caps caps = Caps::NONE; // of names with a number for each segment
  bool have_numbers = true; // whether a "%d" in one of `segments` stands for that; else it is a name like others
  std::string folder_of_parts = {}; // then, if it is not empty, the closed parts are written there in place of the meshes
};

// By its name: "flat", "faired" or "hull"; none if it is empty.
Caps caps_of_name(const std::string& name);

// Throws an `Error` if one of them cannot be written. Good to know before a long computation.
void check_can_be_written(const Output_names& names, const Format_options& options);

// Writes all or, with an `Error`, nothing. Notes how long it takes.
void write_findings(Findings& findings, const Output_names& names, const Recorder::Progress& progress = {});

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_WRITE_FINDINGS_H
