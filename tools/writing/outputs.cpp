// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/outputs.h"

#include "command_line/Error.h"
#include "reading/lower_case_extension.h"
#include "writing/formats.h"
#include "writing/part_names.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace tool {
namespace {

using Write = void (*)(std::ostream&, const Output&);

struct Format
{
  std::string extension;
  std::string description;
  Write write;
  bool holds_a_mesh = true; // then there can be a file per segment
  bool is_in_single_precision = false;
};

const std::vector<Format>& formats()
{
  constexpr bool is_mesh = true, is_in_single_precision = true;
  static const std::vector<Format> table = {
    {".seg", "one segment id a line, line i for face i", write_SEG, !is_mesh},
    {".npy", "numpy: one segment id a face, 32 bits", write_NPY, !is_mesh},
    {".ply", "binary mesh: colours and scalars (MeshLab, CGAL), vertex colours (Blender)", write_PLY},
    {".off", "mesh with face colours (CGAL, MeshLab)", write_OFF},
    {".obj",
     "mesh with a group and a material a segment, and .mtl beside it (Blender, slicers, Rhino, Cinema "
     "4D)",
     write_OBJ},
    {".stl", "binary triangles, without segments", write_STL, is_mesh, is_in_single_precision},
    {".3mf", "painted triangles and triangle sets; with --close, a part a segment (slicers)", write_3MF},
    {".glb", "binary glTF 2.0: an object a segment, or slots of one (Blender, engines, browsers)",
     write_GLB},
    {".gltf", "the same as text", write_GLTF},
    {".usda", "USD: a subset with a material a segment (Omniverse, Unity)", write_USDA},
    {".vtp", "VTK polygonal data with cell data segment and color (ParaView, PyVista)", write_VTP}};
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

void check_single_precision(const std::string& name, const std::vector<Point>& points)
{
  for (const Point& point : points)
    for (int c = 0; c < 3; ++c)
      if (!std::isfinite(static_cast<float>(point[c])))
        throw Error(name,
                    "cannot be written: the format has single precision, and coordinates are larger");
}

void write(const std::string& name,
           const Segmented_soup& segmented,
           const Format_options& options,
           const std::string& companion,
           Output_files& files)
{
  const Format& format = *find_format(name);
  if (format.is_in_single_precision)
    check_single_precision(name, segmented.soup.points);
  const Output output = {segmented, options, std::filesystem::path(companion).filename().string(),
                         std::filesystem::path(name).parent_path().string()};
  files.add(name, [&](std::ostream& out) { format.write(out, output); });
  if (!companion.empty())
    files.add(companion, [&](std::ostream& out) { write_MTL(out, output); });
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

bool holds_parts(const std::string& name)
{
  return find_format(name)->write == write_3MF;
}

std::string companion_of(const std::string& name, const Format_options& options)
{
  return find_format(name)->write == write_OBJ && !is_pattern(name) && !options.are_colors_of_input
           ? std::filesystem::path(name).replace_extension(".mtl").string()
           : "";
}

std::string note_on_single_precision(const std::vector<std::string>& names, const Polygon_soup& soup)
{
  if (std::none_of(names.begin(), names.end(), [](const std::string& name) { return find_format(name)->is_in_single_precision; }))
    return "";
  const auto is_lost = [&](std::size_t i, std::size_t j)
  {
    const Point &a = soup.points[i], &b = soup.points[j];
    const auto is_equal = [&](int c) { return static_cast<float>(a[c]) == static_cast<float>(b[c]); };
    return a != b && is_equal(0) && is_equal(1) && is_equal(2);
  };
  std::size_t number = 0;
  for (const Corners& polygon : soup.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i)
      number += is_lost(polygon[i], polygon[(i + 1) % polygon.size()]) ? 1 : 0;
  return number == 0 ? "" : "STL has single precision, in which " + std::to_string(number) +
                              (number == 1 ? " side of a face has" : " sides of faces have") +
                              " no length: move the mesh to the origin, or choose another format";
}

void check_output_format(const std::string& format)
{
  if (!find_format("mesh." + format))
    throw std::invalid_argument("--format: '" + format + "' is none of html, " + known_extensions());
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
    throw std::invalid_argument("-o: '" + name +
                                "' has a %d or %s elsewhere than once in the file's name");
}

void check_format_options(const Format_options& options)
{
  const std::string& name = options.array_name;
  if (name.empty() || !std::all_of(name.begin(), name.end(),
                                   [](unsigned char c)
                                   { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.'; }))
    throw std::invalid_argument("--array-name: '" + name +
                                "' is no word of letters, digits, '_', '-' and '.'");
  if (name == "color" || name == "old_face")
    throw std::invalid_argument("--array-name: '" + name + "' is the name of another array");
}

void add_parts(const std::vector<std::string>& names,
               const std::vector<Segmented_soup>& parts,
               const Format_options& options,
               Output_files& files)
{
  files.make_folder_of(names.front());
  for (std::size_t s = 0; s < parts.size(); ++s)
    write(names[s], options.are_faces_triangulated ? triangulated(parts[s]) : parts[s], options, "",
          files);
}

void add_output(const std::string& name,
                const Segmented_soup& segmented,
                const Format_options& options,
                Output_files& files)
{
  const bool is_cut = options.are_faces_triangulated && holds_a_mesh(name);
  write(name, is_cut ? triangulated(segmented) : segmented, options, companion_of(name, options), files);
}

void add_output_of_parts(const std::string& name,
                         const std::vector<Segmented_soup>& parts,
                         Output_files& files)
{
  files.add(name, [&](std::ostream& out) { write_parts_in_3MF(out, parts); });
}

} // namespace tool
