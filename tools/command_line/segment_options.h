// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All options of segment_by_protrusions, and nowhere else.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_SEGMENT_OPTIONS_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_SEGMENT_OPTIONS_H

#include "segmentation/Findings.h"

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tool {

struct Command_line
{
  std::vector<std::string> inputs; // files, or folders of files; "-" is the standard input
  Segmentation_options options;
  std::vector<std::string> outputs;
  std::string json;    // "-" is the standard output
  std::string report;  // empty: none
  std::string borders; // empty: none
  std::string skeleton; // empty: none
  std::string rig;     // empty: none
  std::string tips;    // empty: none
  std::string joining; // of pieces: empty, "auto", or a gap
  std::string names;   // empty: none
  std::string caps;    // empty: none; else "flat", "faired" or "hull"
  bool has_connectors = false;
  CGAL::Protrusion_segmentation::Connector_options connectors; // if there are some
  bool is_quiet = false;

  // of a collection of meshes
  std::string output_folder;        // empty: there is one mesh, and no collection
  std::vector<std::string> formats; // of what is written for each mesh
  std::size_t jobs = 1;
  bool is_everything_done_again = false;
};

void add_options(CLI::App& app, Command_line& command_line);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_SEGMENT_OPTIONS_H
