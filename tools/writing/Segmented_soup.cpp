// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Segmented_soup.h"

#include "writing/carried_attributes.h"
#include "writing/part_names.h"
#include "writing/triangles.h"

#include <algorithm>
#include <map>

namespace tool {

std::size_t end_of_segments(const Segmented_soup& segmented)
{
  const auto last = std::max_element(segmented.segments.begin(), segmented.segments.end());
  return last == segmented.segments.end() ? 0 : *last + 1;
}

std::vector<std::vector<std::size_t>> faces_of_segments(const Segmented_soup& segmented)
{
  std::vector<std::vector<std::size_t>> result(end_of_segments(segmented));
  for (std::size_t face = 0; face < segmented.segments.size(); ++face)
    result[segmented.segments[face]].push_back(face);
  return result;
}

std::vector<std::string> words_of_segments(const Segmented_soup& segmented)
{
  return names_of_parts("%s", end_of_segments(segmented), segmented.names);
}

Segmented_soup part_of(const Segmented_soup& whole, const std::vector<std::size_t>& faces)
{
  Segmented_soup part;
  part.names = whole.names;
  std::map<std::size_t, std::size_t> indices;
  std::vector<std::size_t> points;
  Polygon corners;
  for (const std::size_t face : faces)
  {
    part.segments.push_back(whole.segments[face]);
    if (!whole.old_faces.empty())
      part.old_faces.push_back(whole.old_faces[face]);
    corners.clear();
    for (const std::size_t corner : whole.soup.polygons[face])
    {
      const auto [position, is_new] = indices.emplace(corner, part.soup.points.size());
      if (is_new)
      {
        part.soup.points.push_back(whole.soup.points[corner]);
        points.push_back(corner);
      }
      corners.push_back(position->second);
    }
    part.soup.polygons.add(corners);
  }
  part.soup.attributes = attributes_of_part(whole.soup.attributes, faces, points);
  return part;
}

std::vector<Segmented_soup> parts_of(const Segmented_soup& segmented, std::size_t number_of_segments)
{
  std::vector<std::vector<std::size_t>> faces = faces_of_segments(segmented);
  faces.resize(number_of_segments);
  std::vector<Segmented_soup> parts;
  for (const std::vector<std::size_t>& faces_of_segment : faces)
    parts.push_back(part_of(segmented, faces_of_segment));
  return parts;
}

Segmented_soup triangulated(const Segmented_soup& segmented)
{
  Segmented_soup result;
  result.names = segmented.names;
  result.soup.points = segmented.soup.points;
  result.soup.attributes = attributes_of_triangles(segmented.soup);
  for (std::size_t face = 0; face < segmented.segments.size(); ++face)
    for_each_triangle(segmented.soup.polygons[face],
                      [&](auto a, auto b, auto c)
                      {
                        result.soup.polygons.add({a, b, c});
                        result.segments.push_back(segmented.segments[face]);
                        result.old_faces.push_back(
                          segmented.old_faces.empty() ? face : segmented.old_faces[face]);
                      });
  return result;
}

} // namespace tool
