// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Output_files.h"

#include "command_line/Error.h"
#include "writing/write_output.h"

#include <cerrno>
#include <iostream>
#include <sstream>
#include <system_error>
#include <utility>

namespace tool
{

Output_files::~Output_files()
{
  std::error_code ignored;
  m_files.clear(); // before the folders that they are in
  for (auto folder = m_made_folders.rbegin(); folder != m_made_folders.rend(); ++folder)
    fs::remove(*folder, ignored); // does nothing to a folder that is not empty
}

void Output_files::check(const std::string& name)
{
  if (is_stream(name))
    return;
  const Deferred_signals deferred_signals;
  const Temporary_file temporary(target_of(name));
  write_file(name, temporary.name(), [](std::ostream&) {});
}

void Output_files::make_folder_of(const std::string& name)
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

void Output_files::add(const std::string& name, const Write& write)
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

void Output_files::publish()
{
  if (Deferred_signals::is_any_waiting())
    return; // nothing appears, and the program ends when all is removed
  m_deferred_signals.reset(); // who reads a pipe may wait for ever
  for (const File& file : m_files)
    if (!file.temporary)
      publish_stream(file);
  m_deferred_signals.emplace();
  for (const File& file : m_files)
    if (file.temporary)
      publish(file);
  m_files.clear();
  m_made_folders.clear();
}

bool Output_files::is_stream(const std::string& name)
{
  return name == "-" || tool::is_stream(name);
}

fs::path Output_files::target_of(const std::string& name)
{
  std::error_code error;
  if (fs::is_directory(name, error))
    throw Error(name, "cannot be written: it is a folder");
  const fs::path target = tool::target_of_links(name);
  if (fs::is_symlink(target, error))
    throw Error(name, "cannot be written: too many links");
  return target;
}

void Output_files::write_file(const std::string& name, const fs::path& file, const Write& write)
{
  errno = 0; // set by the system when a file cannot be opened or written
  if (!tool::write_file(file, write))
    throw Error(name, "cannot be written" +
                          (errno != 0 ? ": " + std::generic_category().message(errno) : ""));
}

void Output_files::publish(const File& file)
{
  if (const std::error_code error = replace_file(file.temporary->name(), target_of(file.name)))
    throw Error(file.name, "cannot be written: " + error.message());
}

void Output_files::publish_stream(const File& file)
{
  const auto write = [&](std::ostream& out) { out << file.content; };
  if (file.name != "-" && !tool::is_standard_output(file.name))
    return write_file(file.name, file.name, write);
  write(std::cout);
  finish_standard_output();
}

} // namespace tool
