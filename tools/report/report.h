// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPORT_REPORT_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPORT_REPORT_H

#include "segmentation/Findings.h"

#include <ostream>

namespace tool
{

// Was three.js found when this program was built?
bool can_write_report();

// Writes a page that needs no other file: the mesh in three dimensions and what is known of each
// segment.
void write_report(std::ostream& out, const Findings& findings);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_REPORT_REPORT_H
