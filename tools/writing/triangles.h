// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_TRIANGLES_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_TRIANGLES_H

#include "reading/Polygon_soup.h"

#include <cstddef>

namespace tool
{

// A fan of triangles around the first corner of the face, for formats that know triangles only. It
// is made for any face, those without area included.
template <typename Corners, typename Add>
void for_each_triangle(const Corners& polygon, const Add& add)
{
  for (std::size_t i = 2; i < polygon.size(); ++i)
    add(polygon[0], polygon[i - 1], polygon[i]);
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_TRIANGLES_H
