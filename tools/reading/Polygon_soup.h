// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_POLYGON_SOUP_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_POLYGON_SOUP_H

#include "reading/Mesh.h"
#include "reading/Surface_attributes.h"

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygons.h>

#include <cstddef>
#include <vector>

namespace tool
{

using Polygon = std::vector<std::size_t>; // the corners of a face, as indices of points
using Polygons = CGAL::Protrusion_segmentation::internal::Polygons; // those of many,
using Corners = Polygons::Corners;                                   // and of one of these

// The faces of a file, all of them and in their order, whatever is wrong with them.
struct Polygon_soup
{
  std::vector<Point> points;
  Polygons polygons;
  Surface_attributes attributes = {};
};

// Those that a reader of CGAL's made.
inline Polygons polygons_of(const std::vector<Polygon>& faces)
{
  Polygons result;
  for (const Polygon& face : faces)
    result.add(face);
  return result;
}

// The same as a vector for each face, for what changes them.
inline std::vector<Polygon> vectors_of(const Polygons& polygons)
{
  std::vector<Polygon> result;
  for (const Corners& corners : polygons)
    result.emplace_back(corners.begin(), corners.end());
  return result;
}

// The triangle that the last of the first `n` corners of a strip makes with the two before it; every other one is turned
// over.
inline Polygon triangle_of_strip(const Polygon& strip, std::size_t n)
{
  return n % 2 == 1 ? Polygon{strip[n - 3], strip[n - 2], strip[n - 1]}
                    : Polygon{strip[n - 2], strip[n - 3], strip[n - 1]};
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_POLYGON_SOUP_H
