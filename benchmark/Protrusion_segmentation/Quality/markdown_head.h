// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The heading of a results file and the command that prints it.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MARKDOWN_HEAD_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MARKDOWN_HEAD_H

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <string>
#include <system_error>

// The value of an option without the folders above the last one, which differ between machines; quoted if need be.
inline std::string printed_argument(const std::string& argument)
{
  const std::size_t equal = argument.find('='), begin = equal == std::string::npos ? 0 : equal + 1;
  std::filesystem::path path(argument.substr(begin));
  path = path.has_filename() ? path : path.parent_path();
  std::error_code error;
  const bool is_path = path.is_absolute() || std::filesystem::exists(path, error);
  const std::string text = is_path ? argument.substr(0, begin) + path.filename().string() : argument;
  return text.find_first_of(" ()'") == std::string::npos ? text : '"' + text + '"';
}

// `level` is that of the heading, such as "##".
inline void write_head(std::ostream& out,
                       const std::string& level,
                       const std::string& title,
                       const std::string& program,
                       int argc,
                       const char* const* argv)
{
  out << level << " " << title << "\n\n```\n" << program;
  for (int i = 1; i < argc; ++i)
    out << " " << printed_argument(argv[i]);
  out << "\n```\n\n";
}

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_MARKDOWN_HEAD_H
