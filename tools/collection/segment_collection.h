// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many meshes in one call: each gets its files in a folder, and none keeps the others from theirs.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COLLECTION_SEGMENT_COLLECTION_H
#define PROTRUSION_SEGMENTATION_TOOLS_COLLECTION_SEGMENT_COLLECTION_H

#include "command_line/segment_options.h"

namespace tool
{

// Segments all meshes that `command_line.inputs` name or, in folders, hold. Prints a line for each. Throws an `Error`
// with their number if some failed.
void segment_collection(const Command_line& command_line);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COLLECTION_SEGMENT_COLLECTION_H
