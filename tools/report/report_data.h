// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPORT_REPORT_DATA_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPORT_REPORT_DATA_H

#include "segmentation/Findings.h"

#include <string>

namespace tool {

// What the page of --report shows, in JSON: the record of --json, colours, and the mesh. Model.js reads it.
std::string report_data(const Findings& findings);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_REPORT_REPORT_DATA_H
