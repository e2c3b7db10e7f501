// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_FAIRED_PARTS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_FAIRED_PARTS_H

#include "reading/Mesh.h"
#include "reading/Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace tool
{

// For each segment its faces, as triangles, and round caps that continue its surface. Every part of a closed mesh is
// closed; it has its own caps, so that volumes do not add up. A hole that touches a border of the mesh gets no cap.
// A cap is flat where faces around it are single points. A face that is a line or a point may get a vertex in the middle.
std::vector<Polygon_soup> faired_parts(const Mesh& mesh,
                                      const std::vector<std::size_t>& segment_of_face,
                                      std::size_t number_of_segments);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_FAIRED_PARTS_H
