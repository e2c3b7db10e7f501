// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_CLOSED_PARTS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_CLOSED_PARTS_H

#include "reading/Mesh.h"
#include "reading/Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace tool
{

// For each segment its faces and the triangles that close it. Where a segment and all that sticks out of it is cut off, both sides get the same cap, turned
// over: so all parts of a closed mesh are closed, and their volumes add up to the whole. A border that ends at a border
// of the mesh gets no cap. `parents` has for each segment what it sticks out of, itself for a body.
std::vector<Polygon_soup> closed_parts(const Mesh& mesh,
                                      const std::vector<std::size_t>& segment_of_face,
                                      const std::vector<std::size_t>& parents);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_CLOSED_PARTS_H
