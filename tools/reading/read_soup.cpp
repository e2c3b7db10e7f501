// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/read_soup.h"

#include "command_line/Error.h"
#include "command_line/number.h"
#include "reading/Format_error.h"
#include "reading/Lines.h"
#include "reading/formats.h"
#include "reading/lower_case_extension.h"
#include "reading/read_bytes.h"

#include <cctype>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>
#include <vector>

namespace tool
{
namespace
{

struct Format
{
  std::string extension;
  Polygon_soup (*read)(const std::string& bytes);
  Polygon_soup (*read_with_others)(const std::string& bytes, const std::string& folder) = nullptr; // files beside it
};

const std::vector<Format>& formats()
{
  static const std::vector<Format> table = {
    {".off", read_OFF}, {".obj", read_OBJ}, {".ply", read_PLY}, {".stl", read_STL}, {".ts", read_TS},
#ifdef PROTRUSION_SEGMENTATION_HAS_VTK
    {".vtp", read_VTP},
#endif
#ifdef PROTRUSION_SEGMENTATION_HAS_3MF
    {".3mf", read_3MF},
#endif
#ifdef PROTRUSION_SEGMENTATION_HAS_GLTF
    {".glb", nullptr, read_glTF}, {".gltf", nullptr, read_glTF},
#endif
  };
  return table;
}

std::string extension_of(const std::string& file_name)
{
  const std::string extension = lower_case_extension(file_name);
  return extension == ".gz" ? lower_case_extension(file_name.substr(0, file_name.size() - extension.size()))
                            : extension;
}

const Format* find_format(const std::string& extension)
{
  for (const Format& format : formats())
    if (format.extension == extension)
      return &format;
  return nullptr;
}

// Of what comes without a name that tells, as through a pipe.
std::string extension_of_content(const std::string& bytes)
{
  Lines lines(bytes);
  std::string_view first;
  while (first.empty() && lines.next())
    first = without_comment(lines.line());
  const std::string_view word = take_word(first);
  if (word == "ply")
    return ".ply";
  if (word == "GOCAD")
    return ".ts";
  if (word.substr(0, 5) == "<?xml" || word.substr(0, 8) == "<VTKFile")
    return ".vtp";
  if (word.substr(0, 2) == "PK")
    return ".3mf";
  if (word.substr(0, 4) == "glTF" || word.substr(0, 1) == "{")
    return ".glb";
  std::string letters;
  for (const char c : word)
    letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::size_t longest_prefix = 5; // STCN4OFF
  if (letters.find("off") <= longest_prefix)
    return ".off";
  const bool is_text = bytes.find('\0') == std::string::npos;
  if (letters == "solid" || is_binary_STL(bytes) || !is_text)
    return ".stl";
  return number<std::size_t>(word) ? ".off" : ".obj";
}

void check(const Polygon_soup& soup)
{
  if (soup.polygons.empty())
    throw Format_error("has no faces");
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!std::isfinite(soup.points[i][c]))
        throw Format_error("vertex " + std::to_string(i) + " has no finite coordinates");
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
    for (const std::size_t corner : soup.polygons[i])
      if (corner >= soup.points.size())
        throw Format_error("face " + std::to_string(i) + " has a corner that does not exist: there are " +
                           std::to_string(soup.points.size()) + " vertices");
}

// By its byte order mark, without which text is hardly saved so.
bool is_UTF_16(const std::string& bytes)
{
  const std::string mark = bytes.substr(0, 2);
  return (mark == "\xff\xfe" || mark == "\xfe\xff") && !is_binary_STL(bytes);
}

std::string folder_of(const std::string& file_name)
{
  const std::string folder = std::filesystem::path(file_name).parent_path().string();
  return folder.empty() ? "." : folder;
}

Polygon_soup read_checked(const std::string& file_name)
{
  const std::string bytes = read_bytes(file_name);
  if (is_UTF_16(bytes))
    throw Format_error("is text in UTF-16; mesh files are in ASCII or UTF-8");
  const std::string name = extension_of(file_name), extension = name.empty() ? extension_of_content(bytes) : name;
  const Format* format = find_format(extension);
  if (format == nullptr)
    throw Format_error("is in the format " + extension.substr(1) + ", which was not built in (known are " +
                       known_formats() + ")");
  Polygon_soup soup = format->read ? format->read(bytes)
                                         : format->read_with_others(bytes, folder_of(file_name));
  for (std::string& file : soup.attributes.material_files)
    file = (std::filesystem::path(folder_of(file_name)) / file).string();
  check(soup);
  return soup;
}

// Refuses a name that tells of no format, before much is read. That there is no such file is for the reader to tell.
void check_name(const std::string& file_name)
{
  const std::string extension = extension_of(file_name);
  std::error_code ignored;
  if (extension.empty() || find_format(extension) != nullptr || !std::filesystem::exists(file_name, ignored))
    return;
  const std::string known = " (known are " + known_formats() + ")";
  if (extension == ".3mf")
    throw Error(file_name,
                "is 3MF, which is read only where lib3mf was found when this program was built" + known);
  if (extension == ".glb" || extension == ".gltf")
    throw Error(file_name,
                "is glTF, which is read only where tinygltf was found when this program was built" + known);
  if (extension == ".vtp")
    throw Error(file_name,
                "is VTP, which is read only where VTK was found when this program was built" + known);
  throw Error(file_name, "is in no known format" + known);
}

} // namespace

std::string known_formats()
{
  std::string names;
  for (const Format& format : formats())
    names += (names.empty() ? "" : ", ") + format.extension.substr(1);
  return names;
}

bool has_mesh_extension(const std::string& file_name)
{
  return find_format(extension_of(file_name)) != nullptr;
}

Polygon_soup read_soup(const std::string& file_name)
{
  check_name(file_name);
  try
  {
    return read_checked(file_name);
  }
  catch (const std::bad_alloc&)
  {
    throw Error(file_name, "announces more than fits into memory");
  }
  catch (const Format_error& error)
  {
    throw Error(file_name, error.what());
  }
}

} // namespace tool
