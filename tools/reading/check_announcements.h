// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What CGAL's readers take on trust: that a file holds as much as it announces.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_CHECK_ANNOUNCEMENTS_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_CHECK_ANNOUNCEMENTS_H

#include "command_line/Error.h"
#include "reading/check_PLY.h"
#include "reading/lower_case_extension.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

namespace tool
{

// Each vertex and each face takes at least one byte.
inline void check_count(const std::string& file_name, double announced)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file_name, error);
  if (!error && announced > double(size))
    throw Error(file_name, "announces more vertices or faces than it can hold");
}

// The counts are the first two numbers, behind a keyword or without one.
inline void check_header_OFF(const std::string& file_name)
{
  std::ifstream in(file_name, std::ios::binary);
  int counts = 0;
  for (std::string line; counts < 2 && std::getline(in, line);)
  {
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string word; counts < 2 && words >> word;)
    {
      if (word == "BINARY")
        return;
      if (word.find_first_not_of("0123456789") != std::string::npos)
        continue;
      double count = 0;
      std::istringstream(word) >> count;
      check_count(file_name, count);
      ++counts;
    }
  }
}

inline void check_announcements(const std::string& file_name)
{
  const std::string extension = lower_case_extension(file_name);
  if (extension == ".off")
    check_header_OFF(file_name);
  else if (extension == ".ply")
    PLY_checker(file_name).check();
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_CHECK_ANNOUNCEMENTS_H
