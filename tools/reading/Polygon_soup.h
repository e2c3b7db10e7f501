// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_POLYGON_SOUP_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_POLYGON_SOUP_H

#include "reading/Mesh.h"
#include "reading/Surface_attributes.h"

#include <cstddef>
#include <vector>

namespace tool
{

using Polygon = std::vector<std::size_t>; // the corners of a face, as indices of points

// The faces of a file, all of them and in their order, whatever is wrong with them.
struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
  Surface_attributes attributes = {};
};

// The triangle that the last of the first `n` corners of a strip makes with the two before it; every other one is turned
// over.
inline Polygon triangle_of_strip(const Polygon& strip, std::size_t n)
{
  return n % 2 == 1 ? Polygon{strip[n - 3], strip[n - 2], strip[n - 1]}
                    : Polygon{strip[n - 2], strip[n - 3], strip[n - 1]};
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_POLYGON_SOUP_H
