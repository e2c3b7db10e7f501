// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_OUTPUT_FILES_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_OUTPUT_FILES_H

#include "writing/Deferred_signals.h"
#include "writing/Temporary_file.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace tool
{

namespace fs = std::filesystem;

// Files that appear all together: each is written under a temporary name beside its place, and
// renamed only when all are complete. Whatever is not published is removed, made folders included.
// The name "-" is the standard output. It, devices and pipes are written first: that fails more
// easily than renaming.
class Output_files
{
public:
  using Write = std::function<void(std::ostream&)>;

  Output_files() = default;
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;
  ~Output_files();

  // Throws an `Error` if `name` cannot be written. Good to know before a long computation.
  static void check(const std::string& name);

  void make_folder_of(const std::string& name);

  void add(const std::string& name, const Write& write);

  void publish();

private:
  struct File
  {
    std::string name;
    std::unique_ptr<Temporary_file> temporary; // of a regular file
    std::string content;                       // of anything else
  };

  // the standard output as "-" or as a file, a device or a pipe
  static bool is_stream(const std::string& name);

  // Links are followed.
  static fs::path target_of(const std::string& name);

  static void write_file(const std::string& name, const fs::path& file, const Write& write);

  static void publish(const File& file);

  static void publish_stream(const File& file);

  std::optional<Deferred_signals> m_deferred_signals{std::in_place}; // until all else is gone
  std::vector<File> m_files;
  std::vector<fs::path> m_made_folders; // the outermost first
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_OUTPUT_FILES_H
