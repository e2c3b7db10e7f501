// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_CARRIED_ATTRIBUTES_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_CARRIED_ATTRIBUTES_H

#include "reading/Polygon_soup.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tool
{

// Those of some of the faces, which have some of the points, as a surface of their own.
Surface_attributes attributes_of_part(const Surface_attributes& whole,
                                      const std::vector<std::size_t>& faces,
                                      const std::vector<std::size_t>& points);

// Those of the triangles that `for_each_triangle()` makes of all faces.
Surface_attributes attributes_of_triangles(const Polygon_soup& whole);

// Those of pieces of the faces: `old_faces[i]` is the face of `whole` that polygon i of `pieces` is a piece of. New corners get
// values between those of the face. Polygons behind these have no values.
Surface_attributes attributes_of_pieces(const Polygon_soup& whole,
                                        const Polygon_soup& pieces,
                                        const std::vector<std::size_t>& old_faces);

// A value for each point, for formats that have one there: none at all if a point has different ones, or a corner has none.
template <std::size_t dimension>
std::vector<std::array<double, dimension>> values_of_points(const Polygon_soup& soup,
                                                            const Corner_values<dimension>& corners)
{
  std::vector<std::array<double, dimension>> result(soup.points.size());
  std::vector<bool> is_known(soup.points.size(), false);
  for (std::size_t face = 0; face < soup.polygons.size(); ++face)
  {
    if (!corners.has(face))
      return {};
    for (std::size_t i = 0; i < soup.polygons[face].size(); ++i)
    {
      const std::size_t point = soup.polygons[face][i];
      const std::array<double, dimension>& value = corners.values[corners.indices[face][i]];
      if (is_known[point] && result[point] != value)
        return {};
      is_known[point] = true;
      result[point] = value;
    }
  }
  return result;
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_CARRIED_ATTRIBUTES_H
