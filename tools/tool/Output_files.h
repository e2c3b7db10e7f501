// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_OUTPUT_FILES_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_OUTPUT_FILES_H

#include "../include/tool_support.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace tool
{

namespace fs = std::filesystem;
using CGAL::Protrusion_segmentation::internal::Temporary_file;

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
  ~Output_files()
  {
    std::error_code ignored;
    m_files.clear(); // before the folders that they are in
    for (auto folder = m_made_folders.rbegin(); folder != m_made_folders.rend(); ++folder)
      fs::remove(*folder, ignored); // does nothing to a folder that is not empty
  }

  // Throws an `Error` if `name` cannot be written. Good to know before a long computation.
  static void check(const std::string& name)
  {
    if (is_stream(name))
      return;
    const Temporary_file temporary(target_of(name));
    write_file(name, temporary.name(), [](std::ostream&) {});
  }

  void make_folder_of(const std::string& name)
  {
    std::vector<fs::path> missing;
    std::error_code error;
    for (fs::path folder = fs::path(name).parent_path();
         !folder.empty() && !fs::exists(folder, error); folder = folder.parent_path())
      missing.push_back(folder);
    for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder)
      if (fs::create_directory(*folder, error))
        m_made_folders.push_back(*folder);
      else if (error)
        throw Error(folder->string(), "cannot be made: " + error.message());
  }

  void add(const std::string& name, const Write& write)
  {
    File file{name, nullptr, {}};
    if (is_stream(name))
    {
      std::ostringstream content;
      write(content);
      file.content = content.str();
    }
    else
    {
      file.temporary = std::make_unique<Temporary_file>(target_of(name));
      write_file(name, file.temporary->name(), write);
    }
    m_files.push_back(std::move(file));
  }

  void publish()
  {
    for (const File& file : m_files)
      if (!file.temporary)
        publish_stream(file);
    for (const File& file : m_files)
      if (file.temporary)
        publish(file);
    m_files.clear();
    m_made_folders.clear();
  }

private:
  struct File
  {
    std::string name;
    std::unique_ptr<Temporary_file> temporary; // of a regular file
    std::string content;                       // of anything else
  };

  // Is this no regular file, and cannot become one?
  static bool is_stream(const std::string& name)
  {
    std::error_code error;
    return name == "-" || (fs::exists(name, error) && !fs::is_regular_file(name, error) &&
                           !fs::is_directory(name, error));
  }

  // Links are followed.
  static fs::path target_of(const std::string& name)
  {
    std::error_code error;
    if (fs::is_directory(name, error))
      throw Error(name, "cannot be written: it is a folder");
    return fs::is_symlink(name, error) ? fs::weakly_canonical(name, error) : fs::path(name);
  }

  static void write_file(const std::string& name, const fs::path& file, const Write& write)
  {
    errno = 0; // set by the system when a file cannot be opened or written
    if (!CGAL::Protrusion_segmentation::internal::write_file(file, write))
      throw Error(name, "cannot be written" +
                            (errno != 0 ? ": " + std::generic_category().message(errno) : ""));
  }

  static void publish(const File& file)
  {
    std::error_code error;
    fs::rename(file.temporary->name(), target_of(file.name), error);
    if (error)
      throw Error(file.name, "cannot be written: " + error.message());
  }

  static void publish_stream(const File& file)
  {
    const auto write = [&](std::ostream& out) { out << file.content; };
    if (file.name != "-")
      return write_file(file.name, file.name, write);
    write(std::cout);
    finish_standard_output();
  }

  std::vector<File> m_files;
  std::vector<fs::path> m_made_folders; // the outermost first
};

} // namespace tool

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_OUTPUT_FILES_H
