// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/outputs.h"

#include "reading/lower_case_extension.h"
#include "writing/glb.h"
#include "writing/palette.h"
#include "writing/part_names.h"
#include "writing/ply.h"
#include "writing/shortest_digits.h"
#include "writing/vtp.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace tool
{
namespace
{

void write_seg(std::ostream& out, const Segmented_soup& segmented)
{
  for (const std::size_t segment : segmented.segments)
    out << segment << "\n";
}

void write_off(std::ostream& out, const Segmented_soup& segmented)
{
  const auto& [points, polygons] = segmented.soup;
  out << "OFF\n" << points.size() << " " << polygons.size() << " 0\n";
  const std::vector<CGAL::IO::Color> colors = segment_colors(segmented.segments);
  for (const Point& point : points)
  {
    write_shortest(out, point);
    out << "\n";
  }
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    out << polygons[i].size();
    for (const std::size_t corner : polygons[i])
      out << " " << corner;
    const CGAL::IO::Color& color = colors[segmented.segments[i]];
    out << " " << int(color.red()) << " " << int(color.green()) << " " << int(color.blue()) << "\n";
  }
}

// A group begins wherever the next face is of another segment, so that faces keep their order.
void write_obj(std::ostream& out, const Segmented_soup& segmented)
{
  const auto& [points, polygons] = segmented.soup;
  const auto last = std::max_element(segmented.segments.begin(), segmented.segments.end());
  const std::vector<std::string> names = names_of_parts("%s", polygons.empty() ? 0 : *last + 1, segmented.names);
  for (const Point& point : points)
  {
    out << "v ";
    write_shortest(out, point);
    out << "\n";
  }
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    if (i == 0 || segmented.segments[i] != segmented.segments[i - 1])
      out << "g " << names[segmented.segments[i]] << "\n";
    out << "f";
    for (const std::size_t corner : polygons[i])
      out << " " << corner + 1;
    out << "\n";
  }
}

struct Format
{
  std::string extension;
  std::string description;
  void (*write)(std::ostream&, const Segmented_soup&);
  bool holds_a_mesh; // then there can be a file per segment
};

const std::vector<Format>& formats()
{
  static const std::vector<Format> table = {
    {".seg", "one segment id a line, line i for face i", write_seg, false},
    {".ply", "binary mesh with colours and a face property segment", write_PLY, true},
    {".off", "mesh with face colours", write_off, true},
    {".obj", "mesh with a group for each segment", write_obj, true},
    {".glb", "glTF 2.0, a coloured mesh for each segment", write_GLB, true},
    {".vtp", "VTK polygonal data with cell data segment and color", write_VTP, true}};
  return table;
}

// The standard output gets the first of the formats.
const Format* find_format(const std::string& name)
{
  const std::string extension = name == "-" ? formats().front().extension : lower_case_extension(name);
  for (const Format& format : formats())
    if (format.extension == extension)
      return &format;
  return nullptr;
}

std::string known_extensions()
{
  std::string known;
  for (const Format& format : formats())
    known += (known.empty() ? "" : ", ") + format.extension;
  return known;
}

// The faces of one segment, with the points that they need.
Segmented_soup part_of(const Segmented_soup& whole, const std::vector<std::size_t>& faces)
{
  Segmented_soup part;
  part.names = whole.names;
  std::map<std::size_t, std::size_t> indices;
  for (const std::size_t face : faces)
  {
    part.segments.push_back(whole.segments[face]);
    if (!whole.old_faces.empty())
      part.old_faces.push_back(whole.old_faces[face]);
    part.soup.polygons.emplace_back();
    for (const std::size_t corner : whole.soup.polygons[face])
    {
      const auto [position, is_new] = indices.emplace(corner, part.soup.points.size());
      if (is_new)
        part.soup.points.push_back(whole.soup.points[corner]);
      part.soup.polygons.back().push_back(position->second);
    }
  }
  return part;
}

} // namespace

std::vector<std::string> output_formats()
{
  std::vector<std::string> result;
  for (const Format& format : formats())
    result.push_back(format.extension + ": " + format.description);
  return result;
}

std::vector<std::string> output_extensions()
{
  std::vector<std::string> result;
  for (const Format& format : formats())
    result.push_back(format.extension);
  return result;
}

bool holds_a_mesh(const std::string& name)
{
  return find_format(name)->holds_a_mesh;
}

void check_output_format(const std::string& format)
{
  if (!find_format("mesh." + format))
    throw std::invalid_argument("--format: '" + format + "' is none of " + known_extensions());
}

void check_output_name(const std::string& name)
{
  const Format* format = find_format(name);
  if (!format)
    throw std::invalid_argument("-o: '" + name + "' has none of the extensions " + known_extensions());
  if (!is_pattern(name))
    return;
  if (!format->holds_a_mesh)
    throw std::invalid_argument("-o: '" + name + "' has a %d or %s, but " + format->extension +
                                " files are of the whole mesh");
  if (!is_valid_pattern(name))
    throw std::invalid_argument("-o: '" + name + "' has a %d or %s elsewhere than once in the file's name");
}

std::vector<Segmented_soup> parts_of(const Segmented_soup& segmented, std::size_t number_of_segments)
{
  std::vector<std::vector<std::size_t>> faces_of(number_of_segments);
  for (std::size_t face = 0; face < segmented.segments.size(); ++face)
    faces_of[segmented.segments[face]].push_back(face);
  std::vector<Segmented_soup> parts;
  for (const std::vector<std::size_t>& faces : faces_of)
    parts.push_back(part_of(segmented, faces));
  return parts;
}

void add_parts(const std::vector<std::string>& names, const std::vector<Segmented_soup>& parts, Output_files& files)
{
  files.make_folder_of(names.front());
  for (std::size_t s = 0; s < parts.size(); ++s)
    add_output(names[s], parts[s], files);
}

void add_output(const std::string& name, const Segmented_soup& segmented, Output_files& files)
{
  files.add(name, [&](std::ostream& out) { find_format(name)->write(out, segmented); });
}

} // namespace tool
