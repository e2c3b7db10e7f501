// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text as its lines and words. Lines may end as on any system.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_LINES_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_LINES_H

#include <cstddef>
#include <string>
#include <string_view>

namespace tool
{

constexpr std::string_view blanks = " \t\v\f\r";

inline std::string_view trim(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Takes the first word off `text`; an empty one if there is none.
inline std::string_view take_word(std::string_view& text)
{
  text = trim(text);
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

inline std::string_view without_comment(std::string_view line)
{
  return trim(line.substr(0, line.find('#')));
}

// Goes through the lines of a text. They are counted from 1.
class Lines
{
public:
  explicit Lines(std::string_view text) : m_rest(text) {}

  // Moves on to the next line; returns false at the end.
  bool next()
  {
    if (m_rest.empty())
      return false;
    const std::size_t end = m_rest.find_first_of("\r\n");
    m_line = m_rest.substr(0, end);
    const bool is_double = end != std::string_view::npos && m_rest.substr(end, 2) == "\r\n";
    m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + (is_double ? 2 : 1));
    ++m_number;
    return true;
  }

  std::string_view line() const { return m_line; }
  std::size_t line_number() const { return m_number; }
  std::string_view rest() const { return m_rest; } // behind the line

private:
  std::string_view m_rest;
  std::string_view m_line;
  std::size_t m_number = 0;
};

// For an error: a part of the line that fits into one, in quotation marks.
inline std::string quote(std::string_view line)
{
  constexpr std::size_t enough = 40;
  std::string quoted = "'";
  for (const char c : line.substr(0, enough))
    quoted += c >= ' ' && c <= '~' ? c : '?';
  return quoted + (line.size() > enough ? "...'" : "'");
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_LINES_H
