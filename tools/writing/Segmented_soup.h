// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_SEGMENTED_SOUP_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_SEGMENTED_SOUP_H

#include "reading/Polygon_soup.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tool {

// What is written: the faces of the file that was read, all of them, or pieces of these, with their segments.
struct Segmented_soup
{
  Polygon_soup soup;
  std::vector<std::size_t> segments; // of the faces
  std::vector<std::size_t>
    old_faces; // of the file, that the faces are pieces of; empty: the faces are those of the file
  std::vector<std::string> names; // of the segments; empty for those without, and at all

  std::string name_of(std::size_t segment) const
  {
    return segment < names.size() && !names[segment].empty() ? names[segment]
                                                             : "segment " + std::to_string(segment);
  }
};

// One more than the largest of the segments.
std::size_t end_of_segments(const Segmented_soup& segmented);

// The faces of each segment, in their order. Some may have none.
std::vector<std::vector<std::size_t>> faces_of_segments(const Segmented_soup& segmented);

// The names of the segments as different words of letters, digits, '-', '_' and '.'.
std::vector<std::string> words_of_segments(const Segmented_soup& segmented);

// Some faces, with the points that they need.
Segmented_soup part_of(const Segmented_soup& whole, const std::vector<std::size_t>& faces);

// The faces of each segment.
std::vector<Segmented_soup> parts_of(const Segmented_soup& segmented, std::size_t number_of_segments);

// The faces cut into triangles, with the numbers of their old faces.
Segmented_soup triangulated(const Segmented_soup& segmented);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_SEGMENTED_SOUP_H
