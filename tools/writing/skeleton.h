// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_SKELETON_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_SKELETON_H

#include "segmentation/Findings.h"
#include "writing/formats.h"

#include <CGAL/Protrusion_segmentation/Skeleton_joint.h>

#include <ostream>
#include <vector>

namespace tool
{

using Joint = CGAL::Protrusion_segmentation::Skeleton_joint<Point>;

// Enough for lines that follow a bent limb.
constexpr int inner_joints_of_lines = 8;

std::vector<Joint> find_skeleton(const Findings& findings, int number_of_inner_joints = 0);

// The bones as lines of VTK as XML text, with their segments.
void write_skeleton(std::ostream& out, const std::vector<Joint>& joints);

// glTF, binary or as text, of one mesh whose segments hang on joints. A vertex at a border moves with the segment nearer to the
// body, so that nothing tears.
void write_rig(std::ostream& out, const Output& output, const std::vector<Joint>& joints, bool is_binary);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_SKELETON_H
