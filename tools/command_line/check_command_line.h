// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Refuses what makes no sense on the command line of segment_by_protrusions, before anything is read.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_CHECK_COMMAND_LINE_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_CHECK_COMMAND_LINE_H

namespace CLI {
class App;
}

namespace tool {

struct Command_line;

// Throws a `CLI::ValidationError` that names the option.
void check(const CLI::App& app, const Command_line& command_line);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_CHECK_COMMAND_LINE_H
