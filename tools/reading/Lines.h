// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text as its lines and words. Lines may end as on any system.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_LINES_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_LINES_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace tool
{

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r'; }

inline std::string_view trim(std::string_view text)
{
  while (!text.empty() && is_blank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back()))
    text.remove_suffix(1);
  return text;
}

// Takes the first word off `text`; an empty one if there is none.
inline std::string_view take_word(std::string_view& text)
{
  text = trim(text);
  const auto end = std::find_if(text.begin(), text.end(), is_blank);
  const std::string_view word = text.substr(0, std::size_t(end - text.begin()));
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
    const auto is_end = [](char c) { return c == '\n' || c == '\r'; };
    m_line = m_rest.substr(0, std::size_t(std::find_if(m_rest.begin(), m_rest.end(), is_end) - m_rest.begin()));
    m_rest.remove_prefix(m_line.size());
    const bool is_double = m_rest.substr(0, 2) == "\r\n";
    m_rest.remove_prefix((std::min)(m_rest.size(), std::size_t(is_double ? 2 : 1)));
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
