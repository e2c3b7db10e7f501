// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_HULLS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_HULLS_H

#include "reading/Mesh.h"
#include "reading/Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace tool
{

// The convex hull of each segment, of triangles. That of points in a plane is flat.
std::vector<Polygon_soup> convex_hulls(const Mesh& mesh,
                                      const std::vector<std::size_t>& segment_of_face,
                                      std::size_t number_of_segments);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_HULLS_H
