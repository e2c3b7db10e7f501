// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What segment_by_protrusions computes: a segmentation by a method and a distance that are chosen
// by name, with all that a visitor is told on the way.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SEGMENT_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SEGMENT_H

#include "reading/Mesh.h"
#include "segmentation/Findings.h"

#include <string>
#include <vector>

namespace tool
{

// What can be chosen by name. `options` are the command line options that have a meaning only with
// this choice.
struct Choice
{
  std::string name;
  std::string description;
  std::vector<std::string> options;
};
std::vector<Choice> methods();
std::vector<Choice> distances();

// Was oneTBB found when this was built?
bool can_use_threads();

// Throws std::invalid_argument if an option has a value that makes no sense.
void check_options(const Segmentation_options& options);

// Tips among the options are faces of the mesh here; `patches` are those of the faces, as for `face_patch_map`, or none.
Segmentation
segment(const Mesh& mesh,
        const std::vector<std::size_t>& patches,
        const Segmentation_options& options,
        const Recorder::Progress& progress);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SEGMENT_H
