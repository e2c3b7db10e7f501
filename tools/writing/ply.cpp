// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/formats.h"

#include "writing/binary_numbers.h"
#include "writing/palette.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tool {
namespace {

constexpr std::size_t most_corners_in_a_byte = 255;

void write_color(std::ostream& out, const CGAL::IO::Color& color)
{
  const std::array<char, 4> bytes = {static_cast<char>(color.red()), static_cast<char>(color.green()),
                                     static_cast<char>(color.blue()), static_cast<char>(255)};
  out.write(bytes.data(), bytes.size());
}

std::vector<std::size_t> segments_of_points(const Segmented_soup& segmented)
{
  std::vector<std::size_t> result(segmented.soup.points.size(), 0);
  for (std::size_t i = 0; i < segmented.segments.size(); ++i)
    for (const std::size_t corner : segmented.soup.polygons[i])
      result[corner] = segmented.segments[i];
  return result;
}

bool has_many_corners(const Polygon& polygon)
{
  return polygon.size() > most_corners_in_a_byte;
}

void write_header(std::ostream& out, const Segmented_soup& segmented, bool is_wide)
{
  const std::string color =
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << segmented.soup.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << color << "property uint segment\nelement face " << segmented.soup.polygons.size()
      << "\nproperty list " << (is_wide ? "uint" : "uchar")
      << " int vertex_indices\nproperty uint segment\n"
      << (segmented.old_faces.empty() ? "" : "property uint old_face\n")
      << "property float quality\n" // what MeshLab reads of numbers of faces
      << color << "end_header\n";
}

} // namespace

void write_PLY(std::ostream& out, const Output& output)
{
  const Segmented_soup& segmented = output.surface;
  const std::vector<Polygon>& polygons = segmented.soup.polygons;
  const bool is_wide = std::any_of(polygons.begin(), polygons.end(), has_many_corners);
  write_header(out, segmented, is_wide);
  const std::vector<std::size_t> segments = segments_of_points(segmented);
  const std::size_t all = (std::max)(end_of_segments(segmented),
                                     std::size_t(1)); // 0 for points of no face
  std::vector<CGAL::IO::Color> colors;
  for (std::size_t segment = 0; segment < all; ++segment)
    colors.push_back(segment_color(segment));
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
      write_double(out, segmented.soup.points[i][c]);
    write_color(out, colors[segments[i]]);
    write_bits(out, static_cast<std::uint32_t>(segments[i]));
  }
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    if (is_wide)
      write_bits(out, static_cast<std::uint32_t>(polygons[i].size()));
    else
      write_bits(out, static_cast<std::uint8_t>(polygons[i].size()));
    for (const std::size_t corner : polygons[i])
      write_bits(out, static_cast<std::uint32_t>(corner));
    write_bits(out, static_cast<std::uint32_t>(segmented.segments[i]));
    if (!segmented.old_faces.empty())
      write_bits(out, static_cast<std::uint32_t>(segmented.old_faces[i]));
    write_float(out, double(segmented.segments[i]));
    write_color(out, colors[segmented.segments[i]]);
  }
}

} // namespace tool
