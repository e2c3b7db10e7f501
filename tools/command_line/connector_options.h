// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_CONNECTOR_OPTIONS_H
#define PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_CONNECTOR_OPTIONS_H

#include "command_line/segment_options.h"

namespace tool {

// The options of segment_by_protrusions for pegs and sockets.
void add_connector_options(CLI::App& app, Command_line& command_line);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COMMAND_LINE_CONNECTOR_OPTIONS_H
