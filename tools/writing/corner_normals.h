// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_CORNER_NORMALS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_CORNER_NORMALS_H

#include "reading/Polygon_soup.h"

#include <array>
#include <vector>

namespace tool {

using Normal = std::array<float, 3>;

// A unit normal for each corner of each face: the mean, by area, of the faces around the point that are not beyond a crease.
std::vector<std::vector<Normal>> corner_normals(const Polygon_soup& soup);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_CORNER_NORMALS_H
