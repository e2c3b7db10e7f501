// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a file needs to appear under its name only when it is complete.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_TEMPORARY_FILE_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_TEMPORARY_FILE_H

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <random>
#include <string>
#include <system_error>

namespace tool
{

// Calls `write(std::ostream&)`, binary, so that lines end alike everywhere. Returns whether all of
// it reached the file.
template <typename Write>
bool write_file(const std::filesystem::path& file, const Write& write)
{
  std::ofstream out(file, std::ios::binary);
  if (!out)
    return false;
  write(out);
  out.close();
  return !out.fail();
}

// A free name in the same folder, as renaming replaces a file at once only within a file system.
inline std::filesystem::path temporary_name_beside(const std::filesystem::path& file)
{
  constexpr std::size_t most_characters = 200; // of the file's name: longer ones than 255 bytes can hardly be
  std::random_device random;
  std::filesystem::path result;
  std::error_code ignored;
  const std::string name = file.filename().string().substr(0, most_characters);
  do
    result = file.parent_path() / (name + "." + std::to_string(random()) + ".part");
  while (std::filesystem::exists(result, ignored));
  return result;
}

// Removes the temporary file in any case, also when `write` throws; it is gone after renaming.
class Temporary_file
{
public:
  explicit Temporary_file(const std::filesystem::path& target) : m_name(temporary_name_beside(target)) {}
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  ~Temporary_file()
  {
    std::error_code ignored;
    std::filesystem::remove(m_name, ignored);
  }

  const std::filesystem::path& name() const { return m_name; }

private:
  std::filesystem::path m_name;
};

// Puts a file in the place of another one, if there is any, with the permissions of that; returns what is in the way.
inline std::error_code replace_file(const std::filesystem::path& file, const std::filesystem::path& target)
{
  namespace fs = std::filesystem;

  std::error_code error;
  const fs::file_status before = fs::status(target, error);
  error.clear();
  if (fs::is_regular_file(before))
    fs::permissions(file, before.permissions(), error);
  if (!error)
    fs::rename(file, target, error);
  return error;
}

// The standard output by its name as a file. That may be one that has been written to, which must not be replaced.
inline bool is_standard_output(const std::string& file_name)
{
  return file_name == "/dev/stdout";
}

// Whether the name, if need be by links, is that of a device, a pipe or the standard output.
inline bool is_stream(const std::string& file_name)
{
  std::error_code error;
  return is_standard_output(file_name) ||
         (std::filesystem::exists(file_name, error) && !std::filesystem::is_regular_file(file_name, error) &&
          !std::filesystem::is_directory(file_name, error));
}

// What a name stands for by way of links, also if there is nothing yet.
inline std::filesystem::path target_of_links(std::filesystem::path file)
{
  namespace fs = std::filesystem;

  constexpr int most_links = 40; // as the system has it; links may lead in a circle
  std::error_code error;
  for (int i = 0; i < most_links && fs::is_symlink(file, error); ++i)
    file = file.parent_path() / fs::read_symlink(file, error); // which is the latter, if that is absolute
  return file;
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_TEMPORARY_FILE_H
