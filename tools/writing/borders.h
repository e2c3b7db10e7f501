// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_BORDERS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_BORDERS_H

#include "reading/Mesh.h"
#include "segmentation/Findings.h"

#include <CGAL/Protrusion_segmentation/Segment_border.h>

#include <optional>
#include <ostream>
#include <vector>

namespace tool
{

// A line between two segments, and how sure it is.
struct Border : CGAL::Protrusion_segmentation::Segment_border<Point>
{
  std::optional<double> value;       // none between components
  std::optional<double> probability; // none for methods that do not estimate it
};

// Those of the mesh with smooth borders, if there is one.
std::vector<Border> find_borders(const Findings& findings);

// Lines of VTK as XML text, with both segments, length, value and probability of each.
void write_borders(std::ostream& out, const std::vector<Border>& borders);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_BORDERS_H
