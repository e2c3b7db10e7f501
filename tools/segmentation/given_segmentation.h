// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_GIVEN_SEGMENTATION_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_GIVEN_SEGMENTATION_H

#include "segmentation/Findings.h"

#include <cstddef>
#include <vector>

namespace tool {

// Labels of the faces of a mesh as a segmentation: segments in the order of the labels, and what sticks out of what. Their borders
// have no value; the largest protrusion comes first.
Segmentation given_segmentation(const Mesh& mesh, const std::vector<std::size_t>& labels);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_GIVEN_SEGMENTATION_H
