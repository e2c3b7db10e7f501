// SPDX-License-Identifier: GPL-3.0-or-later
//
// What CGAL's readers take on trust: that a file holds as much as it announces.

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_CHECK_ANNOUNCEMENTS_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_CHECK_ANNOUNCEMENTS_H

#include "check_PLY.h"
#include "tool_error.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

namespace tool {

inline std::string lower_case_extension(const std::string& file_name)
{
  std::string extension = std::filesystem::path(file_name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

// Each vertex and each face takes at least one byte.
inline void check_count(const std::string& file_name, double announced)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file_name, error);
  if(!error && announced > double(size))
    throw Error(file_name, "announces more vertices or faces than it can hold");
}

// The counts are the first two numbers, behind a keyword or without one.
inline void check_header_OFF(const std::string& file_name)
{
  std::ifstream in(file_name, std::ios::binary);
  int counts = 0;
  for(std::string line; counts < 2 && std::getline(in, line);)
  {
    std::istringstream words(line.substr(0, line.find('#')));
    for(std::string word; counts < 2 && words >> word;)
    {
      if(word == "BINARY")
        return;
      if(word.find_first_not_of("0123456789") != std::string::npos)
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
  if(extension == ".off")
    check_header_OFF(file_name);
  else if(extension == ".ply")
    PLY_checker(file_name).check();
}

} // namespace tool

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_CHECK_ANNOUNCEMENTS_H
