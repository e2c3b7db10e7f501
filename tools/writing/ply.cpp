// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/formats.h"

#include "writing/binary_numbers.h"
#include "writing/carried_attributes.h"
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

bool has_many_corners(const Corners& polygon)
{
  return polygon.size() > most_corners_in_a_byte;
}

const char* const properties_of_color =
  "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";

// The segment, the colour and the coordinates of each vertex, and what the input has there.
class PLY_vertices
{
public:
  PLY_vertices(const Output& output, const std::vector<CGAL::IO::Color>& colors_of_segments)
    : m_soup(output.surface.soup),
      m_segments(segments_of_points(output.surface)),
      m_colors_of_segments(colors_of_segments),
      m_normals(values_of_points(m_soup, m_soup.attributes.normals)),
      m_textures(values_of_points(m_soup, m_soup.attributes.texture_coordinates)),
      m_has_colors_of_input(output.options.are_colors_of_input && !m_soup.attributes.colors.empty())
  {}

  bool have_colors_of_input() const { return m_has_colors_of_input; }

  void write_header(std::ostream& out) const
  {
    out << "element vertex " << m_soup.points.size()
        << "\nproperty double x\nproperty double y\nproperty double z\n"
        << (m_normals.empty() ? "" : "property double nx\nproperty double ny\nproperty double nz\n")
        << (m_textures.empty() ? "" : "property double s\nproperty double t\n") << properties_of_color
        << "property uint segment\n";
  }

  void write(std::ostream& out) const
  {
    for (std::size_t i = 0; i < m_soup.points.size(); ++i)
    {
      for (int c = 0; c < 3; ++c)
        write_double(out, m_soup.points[i][c]);
      if (!m_normals.empty())
        for (const double coordinate : m_normals[i])
          write_double(out, coordinate);
      if (!m_textures.empty())
        for (const double coordinate : m_textures[i])
          write_double(out, coordinate);
      if (m_has_colors_of_input)
        for (const unsigned char part : m_soup.attributes.colors[i])
          write_bits(out, std::uint8_t(part));
      else
        write_color(out, m_colors_of_segments[m_segments[i]]);
      write_bits(out, static_cast<std::uint32_t>(m_segments[i]));
    }
  }

private:
  const Polygon_soup& m_soup;
  std::vector<std::size_t> m_segments;
  const std::vector<CGAL::IO::Color>& m_colors_of_segments;
  std::vector<std::array<double, 3>> m_normals;
  std::vector<std::array<double, 2>> m_textures;
  bool m_has_colors_of_input;
};

void write_header_of_faces(std::ostream& out,
                           const Segmented_soup& segmented,
                           bool is_wide,
                           bool have_colors)
{
  out << "element face " << segmented.soup.polygons.size() << "\nproperty list "
      << (is_wide ? "uint" : "uchar") << " int vertex_indices\nproperty uint segment\n"
      << (segmented.old_faces.empty() ? "" : "property uint old_face\n")
      << "property float quality\n" // what MeshLab reads of numbers of faces
      << (have_colors ? properties_of_color : "");
}

void write_faces(std::ostream& out,
                 const Segmented_soup& segmented,
                 bool is_wide,
                 const std::vector<CGAL::IO::Color>* colors)
{
  for (std::size_t i = 0; i < segmented.soup.polygons.size(); ++i)
  {
    const Corners polygon = segmented.soup.polygons[i];
    if (is_wide)
      write_bits(out, static_cast<std::uint32_t>(polygon.size()));
    else
      write_bits(out, static_cast<std::uint8_t>(polygon.size()));
    for (const std::size_t corner : polygon)
      write_bits(out, static_cast<std::uint32_t>(corner));
    write_bits(out, static_cast<std::uint32_t>(segmented.segments[i]));
    if (!segmented.old_faces.empty())
      write_bits(out, static_cast<std::uint32_t>(segmented.old_faces[i]));
    write_float(out, double(segmented.segments[i]));
    if (colors != nullptr)
      write_color(out, (*colors)[segmented.segments[i]]);
  }
}

} // namespace

void write_PLY(std::ostream& out, const Output& output)
{
  const Segmented_soup& segmented = output.surface;
  const Polygons& polygons = segmented.soup.polygons;
  const bool is_wide = std::any_of(polygons.begin(), polygons.end(), has_many_corners);
  const std::size_t all = (std::max)(end_of_segments(segmented),
                                     std::size_t(1)); // 0 for points of no face
  std::vector<CGAL::IO::Color> colors;
  for (std::size_t segment = 0; segment < all; ++segment)
    colors.push_back(segment_color(segment));
  const PLY_vertices vertices(output, colors);
  out << "ply\nformat binary_little_endian 1.0\n";
  vertices.write_header(out);
  write_header_of_faces(out, segmented, is_wide, !vertices.have_colors_of_input());
  out << "end_header\n";
  vertices.write(out);
  write_faces(out, segmented, is_wide, vertices.have_colors_of_input() ? nullptr : &colors);
}

} // namespace tool
