// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/formats.h"

#include "writing/palette.h"
#include "writing/shortest_digits.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace tool {
namespace {

void write_names_of_materials(std::ostream& out, const Output& output, bool are_of_input)
{
  namespace fs = std::filesystem;

  if (!output.companion.empty())
    out << "mtllib " << output.companion << "\n";
  if (are_of_input)
    for (const std::string& file : output.surface.soup.attributes.material_files)
    {
      std::error_code error;
      const fs::path path = fs::proximate(file, output.folder.empty() ? "." : output.folder, error);
      out << "mtllib " << (error ? file : path.generic_string()) << "\n";
    }
}

template <std::size_t dimension>
void write_values(std::ostream& out, const char* keyword, const Corner_values<dimension>& corners)
{
  for (const std::array<double, dimension>& value : corners.values)
  {
    out << keyword;
    for (const double coordinate : value)
    {
      out << ' ';
      write_shortest(out, coordinate);
    }
    out << "\n";
  }
}

// A part of a colour from 0 to 1, in as few digits as give the byte back.
void write_part_of_color(std::ostream& out, unsigned char byte)
{
  out << ' ';
  write_shortest(out, std::round(byte / 255. * 1e4) / 1e4);
}

void write_values(std::ostream& out, const Polygon_soup& soup, bool has_colors)
{
  for (std::size_t i = 0; i < soup.points.size(); ++i)
  {
    out << "v ";
    write_shortest(out, soup.points[i]);
    for (std::size_t part = 0; has_colors && part < 3; ++part)
      write_part_of_color(out, soup.attributes.colors[i][part]);
    out << "\n";
  }
  write_values(out, "vt", soup.attributes.texture_coordinates);
  write_values(out, "vn", soup.attributes.normals);
}

// A corner is 'vertex', 'vertex/texture', 'vertex//normal' or 'vertex/texture/normal'.
void write_face(std::ostream& out, const Polygon_soup& soup, std::size_t face)
{
  const bool has_texture = soup.attributes.texture_coordinates.has(face),
             has_normals = soup.attributes.normals.has(face);
  out << "f";
  for (std::size_t i = 0; i < soup.polygons[face].size(); ++i)
  {
    out << " " << soup.polygons[face][i] + 1;
    if (has_texture || has_normals)
      out << "/";
    if (has_texture)
      out << soup.attributes.texture_coordinates.indices[face][i] + 1;
    if (has_normals)
      out << "/" << soup.attributes.normals.indices[face][i] + 1;
  }
  out << "\n";
}

} // namespace

void write_OFF(std::ostream& out, const Output& output)
{
  const Polygon_soup& soup = output.surface.soup;
  const std::vector<std::size_t>& segments = output.surface.segments;
  out << "OFF\n" << soup.points.size() << " " << soup.polygons.size() << " 0\n";
  for (const Point& point : soup.points)
  {
    write_shortest(out, point);
    out << "\n";
  }
  const std::vector<CGAL::IO::Color> colors = segment_colors(segments);
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    out << soup.polygons[i].size();
    for (const std::size_t corner : soup.polygons[i])
      out << " " << corner;
    const CGAL::IO::Color& color = colors[segments[i]];
    out << " " << int(color.red()) << " " << int(color.green()) << " " << int(color.blue()) << "\n";
  }
}

void write_OBJ(std::ostream& out, const Output& output)
{
  const Polygon_soup& soup = output.surface.soup;
  const bool has_materials_of_input = output.options.are_colors_of_input &&
                                      !soup.attributes.materials.empty();
  write_names_of_materials(out, output, has_materials_of_input);
  write_values(out, soup, output.options.are_colors_of_input && !soup.attributes.colors.empty());
  const std::vector<std::string> names = words_of_segments(output.surface);
  const std::vector<std::vector<std::size_t>> faces = faces_of_segments(output.surface);
  std::size_t material = no_index;
  for (std::size_t segment = 0; segment < faces.size(); ++segment)
  {
    if (faces[segment].empty())
      continue;
    out << "g " << names[segment] << "\n";
    if (!output.companion.empty())
      out << "usemtl " << names[segment] << "\n";
    for (const std::size_t face : faces[segment])
    {
      if (has_materials_of_input && soup.attributes.materials[face] != material)
      {
        material = soup.attributes.materials[face];
        out << "usemtl " << (material == no_index ? "none" : soup.attributes.material_names[material])
            << "\n";
      }
      write_face(out, soup, face);
    }
  }
}

void write_MTL(std::ostream& out, const Output& output)
{
  const std::vector<std::string> names = words_of_segments(output.surface);
  for (std::size_t segment = 0; segment < names.size(); ++segment)
  {
    const CGAL::IO::Color color = segment_color(segment);
    out << "newmtl " << names[segment] << "\nKd";
    for (const unsigned char byte : {color.red(), color.green(), color.blue()})
      write_part_of_color(out, byte);
    out << "\nKs 0 0 0\nd 1\n";
  }
}

} // namespace tool
