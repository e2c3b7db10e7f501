// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_JOIN_SEGMENTS_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_JOIN_SEGMENTS_H

#include "segmentation/Findings.h"

#include <cstddef>
#include <vector>

namespace tool {

// Gives the protrusions that `is_joined` names to their parents, or to the nearest ancestors that are left. The others keep
// their order, and get the numbers 0, 1, 2 ... Returns, of each segment as it was, the number of the one it is in now.
std::vector<std::size_t> join_segments(Segmentation& segmentation, const std::vector<bool>& is_joined);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_JOIN_SEGMENTS_H
