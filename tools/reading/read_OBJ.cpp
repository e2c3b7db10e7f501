// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/formats.h"

#include "command_line/number.h"
#include "reading/Normalized_text.h"
#include "reading/OBJ_attributes.h"

#include <CGAL/IO/OBJ.h>

#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>

namespace tool {
namespace {

// Keeps vertices and faces, those with indices of vertices only, and attributes apart. Groups, lines, points, curves and surfaces
// are left out.
class OBJ_normalizer
{
public:
  explicit OBJ_normalizer(const std::string& bytes)
  {
    for (Lines lines(bytes); lines.next();)
      add_line(lines);
    if (m_faces == 0)
      throw Format_error("has no faces");
    if (m_largest_index > m_vertices)
      throw Format_error(m_line_of_largest, missing_vertex(m_largest_index));
  }

  const Normalized_text& text() const { return m_text; }
  Surface_attributes take_attributes(std::size_t number_of_points)
  {
    return m_attributes.take(number_of_points);
  }

private:
  // It may have a # in it, and the path of a folder may end with a backslash.
  static bool is_a_name(std::string_view line)
  {
    const std::string_view keyword = take_word(line);
    return keyword == "o" || keyword == "g" || keyword == "mtllib" || keyword == "usemtl";
  }

  // A line that ends with a backslash goes on in the next one.
  void add_line(Lines& lines)
  {
    const std::size_t number = lines.line_number();
    std::string_view line = trim(lines.line());
    if (line.empty() || line.back() != '\\' || line.front() == '#' || is_a_name(line))
      return add_statement(line, number);
    std::string joined;
    for (; !line.empty() && line.back() == '\\'; line = lines.next() ? trim(lines.line()) : "")
      joined.append(line.substr(0, line.size() - 1)) += ' ';
    joined += line;
    add_statement(joined, number);
  }

  void add_statement(std::string_view line, std::size_t number)
  {
    line = line.find('#') == line.npos || is_a_name(line) ? trim(line) : without_comment(line);
    std::string_view words = line;
    const std::string_view keyword = take_word(words);
    m_attributes.add(keyword, words);
    if (keyword == "v")
    {
      ++m_vertices;
      m_text << line;
      m_text.end_line(number);
    }
    else if (keyword == "f" || keyword == "fo") // fo: of old files
      add_face(words, number);
    else if (!keyword.empty() && std::isalpha(static_cast<unsigned char>(keyword.front())) == 0)
      throw Format_error(number, "cannot make sense of " + quote(line));
  }

  void add_face(std::string_view words, std::size_t line)
  {
    m_text << "f";
    for (std::string_view word = take_word(words); !word.empty(); word = take_word(words))
      m_text << " " << index_of_vertex(word, line);
    m_text.end_line(line);
    ++m_faces;
  }

  // A corner is 'vertex', 'vertex/texture', 'vertex//normal' or 'vertex/texture/normal'.
  std::size_t index_of_vertex(std::string_view corner, std::size_t line)
  {
    const std::size_t slash = corner.find('/');
    const auto index = number<int>(corner.substr(0, slash)); // as CGAL's reader has them
    const bool is_corner = index && (slash == corner.npos ||
                                     corner.find_first_not_of("+-0123456789/", slash) == corner.npos);
    if (!is_corner)
      throw Format_error(line, quote(corner) + " is no corner of a face");
    if (*index == 0 || -std::ptrdiff_t(*index) > std::ptrdiff_t(m_vertices))
      throw Format_error(line, missing_vertex(*index));
    const std::size_t result = static_cast<std::size_t>(
      *index > 0 ? *index : std::ptrdiff_t(m_vertices) + *index + 1);
    if (result > m_largest_index)
    {
      m_largest_index = result;
      m_line_of_largest = line;
    }
    return result;
  }

  template <typename Index>
  std::string missing_vertex(Index index) const
  {
    return "a face names vertex " + std::to_string(index) + " of " + std::to_string(m_vertices);
  }

  Normalized_text m_text;
  OBJ_attributes m_attributes;
  std::size_t m_vertices = 0;
  std::size_t m_faces = 0;
  std::size_t m_largest_index = 0;
  std::size_t m_line_of_largest = 0;
};

} // namespace

Polygon_soup read_OBJ(const std::string& bytes)
{
  Polygon_soup soup;
  std::vector<Polygon> faces;
  OBJ_normalizer normalizer(bytes);
  normalizer.text().read_by([&](std::istream& in)
                            { return CGAL::IO::read_OBJ(in, soup.points, faces); });
  soup.polygons = polygons_of(faces);
  soup.attributes = normalizer.take_attributes(soup.points.size());
  return soup;
}

} // namespace tool
