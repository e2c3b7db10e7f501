// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_MAKE_CLOSED_PARTS_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_MAKE_CLOSED_PARTS_H

#include "segmentation/Findings.h"
#include "segmentation/write_findings.h"
#include "writing/Segmented_soup.h"

#include <vector>

namespace tool {

// A mesh of each segment, closed where it was cut off, with what the file says of its faces. Notes the connectors.
std::vector<Segmented_soup> make_closed_parts(Findings& findings, const Polygon_soup& file, Caps caps);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_MAKE_CLOSED_PARTS_H
