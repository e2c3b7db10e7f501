// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_GLB_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_GLB_H

#include "writing/Segmented_soup.h"

#include <ostream>

namespace tool
{

// Writes binary glTF 2.0: a node "segment N" for each segment, with a mesh and a material of its own, so
// that segments can be picked one by one in other programs. Coordinates are as in the mesh.
void write_GLB(std::ostream& out, const Segmented_soup& segmented);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_GLB_H
