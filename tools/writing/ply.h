// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Binary PLY. CGAL's writer wants a mesh, in which not all faces of a file have a place.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_PLY_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_PLY_H

#include "writing/Segmented_soup.h"
#include "writing/palette.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>

namespace tool
{

// Little-endian, whatever the machine is.
template <typename Bits>
void write_bits(std::ostream& out, Bits bits)
{
  std::array<char, sizeof(Bits)> bytes;
  for (std::size_t i = 0; i < sizeof(Bits); ++i)
    bytes[i] = static_cast<char>(bits >> 8 * i & 0xff);
  out.write(bytes.data(), bytes.size());
}

inline void write_double(std::ostream& out, double value)
{
  std::uint64_t bits;
  static_assert(sizeof(bits) == sizeof(value));
  std::memcpy(&bits, &value, sizeof(bits));
  write_bits(out, bits);
}

inline void write_color(std::ostream& out, const CGAL::IO::Color& color)
{
  const std::array<char, 4> bytes = {static_cast<char>(color.red()), static_cast<char>(color.green()),
                                     static_cast<char>(color.blue()), static_cast<char>(255)};
  out.write(bytes.data(), bytes.size());
}

// Blender reads the colours of vertices only: a vertex gets that of one of its faces.
inline std::vector<CGAL::IO::Color> colors_of_points(const Segmented_soup& segmented,
                                                     const std::vector<CGAL::IO::Color>& colors_of_segments)
{
  std::vector<CGAL::IO::Color> result(segmented.soup.points.size());
  for (std::size_t i = 0; i < segmented.segments.size(); ++i)
    for (const std::size_t corner : segmented.soup.polygons[i])
      result[corner] = colors_of_segments[segmented.segments[i]];
  return result;
}

inline void write_PLY(std::ostream& out, const Segmented_soup& segmented)
{
  const auto& [points, polygons] = segmented.soup;
  const bool is_wide = std::any_of(polygons.begin(), polygons.end(),
                                   [](const Polygon& polygon) { return polygon.size() > 255; });
  const std::string color =
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << color << "element face " << polygons.size() << "\nproperty list " << (is_wide ? "uint" : "uchar")
      << " int vertex_indices\nproperty uint segment\n"
      << (segmented.old_faces.empty() ? "" : "property uint old_face\n")
      << color << "end_header\n";
  const std::vector<CGAL::IO::Color> colors_of_segments = segment_colors(segmented.segments);
  const std::vector<CGAL::IO::Color> colors = colors_of_points(segmented, colors_of_segments);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
      write_double(out, points[i][c]);
    write_color(out, colors[i]);
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
    write_color(out, colors_of_segments[segmented.segments[i]]);
  }
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_PLY_H
