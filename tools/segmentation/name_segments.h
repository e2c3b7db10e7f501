// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_NAME_SEGMENTS_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_NAME_SEGMENTS_H

#include "command_line/read_tips.h"
#include "segmentation/Findings.h"

namespace tool {

// Gives segments their names, if there are any. Throws an `Error` if these name what is not there.
void name_segments(Findings& findings, const Picked_tips& picked);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_NAME_SEGMENTS_H
