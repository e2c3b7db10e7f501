// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_NORMALIZED_TEXT_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_NORMALIZED_TEXT_H

#include "reading/Format_error.h"
#include "reading/Lines.h"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace tool
{

// The lines of a file as one of CGAL's readers wants them, which knows where each was in the file.
class Normalized_text
{
public:
  Normalized_text& operator<<(std::string_view part)
  {
    m_text += part;
    return *this;
  }
  Normalized_text& operator<<(std::size_t number) { return *this << std::to_string(number); }

  void end_line(std::size_t number_in_file)
  {
    m_text += '\n';
    m_numbers.push_back(number_in_file);
  }

  // Throws a `Format_error` with the line where `read(std::istream&)` came to a stop.
  template <typename Read>
  void read_by(const Read& read) const
  {
    std::istringstream in(m_text);
    if (read(in))
      return;
    in.clear();
    const std::size_t end = static_cast<std::size_t>(
      (std::max)(std::streamoff(in.tellg()), std::streamoff(1)));
    const std::size_t begin = end < 2 ? 0 : m_text.rfind('\n', end - 2) + 1; // of the line that it ends
    const std::size_t line = std::count(m_text.begin(), m_text.begin() + std::ptrdiff_t(begin), '\n');
    if (line >= m_numbers.size())
      throw Format_error("ends too early");
    const std::string_view content = std::string_view(m_text).substr(begin, m_text.find('\n', begin) - begin);
    throw Format_error(m_numbers[line], "cannot make sense of " + quote(content));
  }

private:
  std::string m_text;
  std::vector<std::size_t> m_numbers; // of each line, in the file
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_NORMALIZED_TEXT_H
