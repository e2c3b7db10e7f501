// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "collection/list_meshes.h"

#include "command_line/Error.h"
#include "reading/lower_case_extension.h"
#include "reading/read_soup.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

namespace tool
{
namespace
{

namespace fs = std::filesystem;

// Is it the folder or in it?
bool is_within(const fs::path& path, const fs::path& folder)
{
  std::error_code ignored;
  const fs::path relative = fs::weakly_canonical(path, ignored).lexically_relative(fs::weakly_canonical(folder, ignored));
  return !relative.empty() && *relative.begin() != "..";
}

// The name is the path within the folder, with the extension still.
void add_folder(const std::string& folder,
                const std::string& output_folder,
                std::vector<Mesh_in_collection>& meshes)
{
  const bool is_output_beside = !is_within(folder, output_folder);
  std::error_code error;
  const fs::recursive_directory_iterator end;
  fs::recursive_directory_iterator entry(folder, error);
  std::vector<fs::path> files;
  fs::path last = folder;
  for (; !error && entry != end; entry.increment(error))
  {
    last = entry->path();
    if (is_output_beside && entry->is_directory() && is_within(entry->path(), output_folder))
      entry.disable_recursion_pending();
    else if (entry->is_regular_file() && has_mesh_extension(entry->path().string()))
      files.push_back(entry->path());
  }
  if (error)
    throw Error(last.string(), "cannot be read: " + error.message());
  if (files.empty())
    throw Error(folder, "has no mesh in it (known are " + known_formats() + ")");
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    meshes.push_back({file.string(), file.lexically_relative(folder).generic_string()});
}

std::string without_extension(const std::string& name)
{
  const fs::path path = lower_case_extension(name) == ".gz" ? fs::path(name).replace_extension()
                                                            : fs::path(name);
  return fs::path(path).replace_extension().generic_string();
}

} // namespace

std::vector<Mesh_in_collection> list_meshes(const std::vector<std::string>& inputs,
                                            const std::string& output_folder)
{
  std::vector<Mesh_in_collection> meshes;
  std::error_code ignored;
  for (const std::string& input : inputs)
    if (fs::is_directory(input, ignored))
      add_folder(input, output_folder, meshes);
    else
      meshes.push_back({input, fs::path(input).filename().generic_string()});

  std::map<std::string, std::size_t> times;
  for (const Mesh_in_collection& mesh : meshes)
    ++times[without_extension(mesh.name)];
  std::set<std::string> names;
  for (Mesh_in_collection& mesh : meshes)
  {
    if (const std::string short_name = without_extension(mesh.name); times[short_name] == 1)
      mesh.name = short_name;
    if (!names.insert(mesh.name).second)
      throw Error(mesh.input, "has the same name as another mesh, and so would its outputs");
  }
  return meshes;
}

} // namespace tool
