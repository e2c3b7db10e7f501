// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/formats.h"

#include "command_line/number.h"
#include "reading/Normalized_text.h"

#include <CGAL/IO/GOCAD.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace tool
{
namespace
{

// Keeps vertices and triangles, the vertices with numbers from 0. In the file these may leave some out, begin anew with
// every surface, and an atom is a further number for a vertex; CGAL's reader takes the first number and counts.
class TS_normalizer
{
public:
  explicit TS_normalizer(const std::string& bytes)
  {
    add("TFACE"); // nothing before it is read
    for (Lines lines(bytes); lines.next();)
    {
      m_line = lines.line_number();
      add_line(trim(lines.line()));
    }
    if (!m_is_ended)
      throw Format_error("ends without 'END'");
    add("END");
  }

  const Normalized_text& text() const { return m_text; }

private:
  void add_line(std::string_view words)
  {
    const std::string_view keyword = take_word(words);
    if (keyword == "GOCAD")
    {
      m_is_ended = false;
      m_numbers.clear();
    }
    else if (keyword == "VRTX" || keyword == "PVRTX") // with properties
      add_vertex(words);
    else if (keyword == "ATOM" || keyword == "PATOM")
    {
      const std::size_t number = new_number(words);
      m_numbers[number] = number_of_vertex(words);
    }
    else if (keyword == "TRGL")
      add_triangle(words);
    else if (keyword == "END")
      m_is_ended = true;
  }

  void add(std::string_view line)
  {
    m_text << line;
    m_text.end_line(m_line);
  }

  void add_vertex(std::string_view words)
  {
    m_numbers[new_number(words)] = m_vertices;
    m_text << "VRTX " << m_vertices++;
    for (int i = 0; i < 3; ++i)
      m_text << " " << take_word(words);
    m_text.end_line(m_line);
  }

  void add_triangle(std::string_view words)
  {
    m_text << "TRGL";
    for (int i = 0; i < 3; ++i)
      m_text << " " << number_of_vertex(words);
    m_text.end_line(m_line);
  }

  std::size_t take_number(std::string_view& words) const
  {
    const std::string_view word = take_word(words);
    const auto result = number<std::size_t>(word);
    if (!result)
      throw Format_error(m_line, quote(word) + " is no number of a vertex");
    return *result;
  }

  std::size_t new_number(std::string_view& words) const
  {
    const std::size_t result = take_number(words);
    if (m_numbers.count(result) > 0)
      throw Format_error(m_line, "there is a vertex " + std::to_string(result) + " already");
    return result;
  }

  std::size_t number_of_vertex(std::string_view& words) const
  {
    const std::size_t number = take_number(words);
    const auto found = m_numbers.find(number);
    if (found == m_numbers.end())
      throw Format_error(m_line, "names vertex " + std::to_string(number) + ", which no line before it has");
    return found->second;
  }

  Normalized_text m_text;
  std::size_t m_line = 0;
  std::size_t m_vertices = 0;
  std::map<std::size_t, std::size_t> m_numbers; // of the vertices of the surface, from their numbers in the file
  bool m_is_ended = false;
};

} // namespace

Polygon_soup read_TS(const std::string& bytes)
{
  Polygon_soup soup;
  std::vector<Polygon> faces;
  TS_normalizer(bytes).text().read_by([&](std::istream& in)
                                      { return CGAL::IO::read_GOCAD(in, soup.points, faces); });
  soup.polygons = polygons_of(faces);
  return soup;
}

} // namespace tool
