// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's reader of OFF does not tell where a file is wrong, and asserts what files may not fulfil. To guard it, a file had
// to be walked through to its end; this takes the vertices and faces along, in a sixth of the time.

#include "reading/formats.h"

#include "command_line/number.h"
#include "reading/Format_error.h"
#include "reading/Lines.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace tool
{
namespace
{

// [ST][C][N][4][n]OFF: what vertices carry. MeshLab writes the first three in another order, as in NCSTOFF.
struct Keyword
{
  bool has_textures = false;
  bool has_colors = false;
  bool has_normals = false;
  bool is_homogeneous = false;
  bool has_dimension = false;
  bool is_there = false;

  // Takes the keyword off the line; counts may follow it without a blank.
  static Keyword take(std::string_view& line)
  {
    Keyword keyword;
    std::string_view rest = line;
    const auto take_part = [&](std::string_view part)
    {
      const bool is_there = rest.substr(0, part.size()) == part;
      rest.remove_prefix(is_there ? part.size() : 0);
      return is_there;
    };
    for (int i = 0; i < 3; ++i) // each once
    {
      keyword.has_textures = keyword.has_textures || take_part("ST");
      keyword.has_colors = keyword.has_colors || take_part("C");
      keyword.has_normals = keyword.has_normals || take_part("N");
    }
    keyword.is_homogeneous = take_part("4");
    keyword.has_dimension = take_part("n");
    keyword.is_there = take_part("OFF") || take_part("off");
    if (!keyword.is_there)
      return {}; // allowed, then the counts come first
    line = rest;
    return keyword;
  }
};

// Reads vertices and faces; colours, normals, textures, comments and empty lines are passed over.
class OFF_reader
{
public:
  OFF_reader(Lines& lines, const Keyword& keyword, std::string_view rest_of_first_line)
    : m_lines(lines),
      m_words(without_comment(rest_of_first_line)),
      m_keyword(keyword)
  {
    read_counts();
    m_is_by_lines = has_a_line_for_each();
    m_soup.points.reserve(m_vertices);
    m_soup.polygons.reserve(m_faces, 3 * m_faces);
    for (std::size_t i = 0; i < m_vertices; ++i)
      add_vertex(i);
    for (std::size_t i = 0; i < m_faces; ++i)
      add_face(i);
    check_end();
  }

  Polygon_soup take_soup() { return std::move(m_soup); }

private:
  // Those of vertices, faces and edges, on one line or more. Of edges nobody wants to know.
  void read_counts()
  {
    if (m_keyword.has_dimension && read_count("dimension") != 3)
      throw Format_error("is not in three dimensions");
    m_vertices = read_count("number of vertices");
    m_faces = read_count("number of faces");
    if (m_faces == 0)
      throw Format_error("has no faces");
    if (!take_word(m_words).empty())
      return;
    Lines ahead = m_lines;
    std::string_view line = next_line(ahead);
    take_word(line);
    if (line.empty())
      m_lines = ahead; // the number of edges, on a line of its own
  }

  std::size_t read_count(const std::string& what)
  {
    move_on_to_words();
    const std::string_view word = take_word(m_words);
    const auto count = number<std::size_t>(word);
    if (!count)
      throw Format_error(m_lines.line_number(), "the " + what + " is " + quote(word));
    if (*count > m_lines.rest().size() + m_words.size() + 1)
      throw Format_error(m_lines.line_number(), "announces a " + what + " that the file cannot hold");
    m_words = trim(m_words);
    return *count;
  }

  // What follows the counts is one thing a line, unless there are too few lines; then nothing but numbers.
  bool has_a_line_for_each() const
  {
    Lines ahead = m_lines;
    std::size_t count = 0;
    while (!next_line(ahead).empty())
      ++count;
    return count >= m_vertices + m_faces || m_keyword.has_colors || m_keyword.has_normals ||
           m_keyword.has_textures;
  }

  void add_vertex(std::size_t vertex)
  {
    begin("vertex", vertex);
    std::array<double, 4> x = {0, 0, 0, 1};
    const std::size_t size = m_keyword.is_homogeneous ? 4 : 3;
    for (std::size_t i = 0; i < size; ++i)
      x[i] = coordinate(next_word("vertex", vertex));
    if (x[3] == 0)
      throw Format_error(m_lines.line_number(), "the vertex is infinitely far away: its last coordinate is 0");
    m_soup.points.emplace_back(x[0] / x[3], x[1] / x[3], x[2] / x[3]);
  }

  double coordinate(std::string_view word) const
  {
    const auto value = number<double>(word);
    if (!value || !std::isfinite(*value))
      throw Format_error(m_lines.line_number(), quote(word) + " is no coordinate");
    return *value;
  }

  void add_face(std::size_t face)
  {
    begin("face", face);
    const std::string_view word = next_word("face", face);
    const auto size = number<std::size_t>(word);
    if (!size)
      throw Format_error(m_lines.line_number(), quote(word) + " is no number of corners");
    m_face.clear(); // what it has room for stays
    for (std::size_t i = 0; i < *size; ++i)
    {
      const std::string_view corner = next_word("face", face);
      const auto index = number<std::ptrdiff_t>(corner);
      if (!index)
        throw Format_error(m_lines.line_number(), quote(corner) + " is no corner of a face");
      if (*index < 0 || *index >= std::ptrdiff_t(m_vertices))
        throw Format_error(m_lines.line_number(), "a face names vertex " + std::to_string(*index) + " of " +
                                                    std::to_string(m_vertices) +
                                                    ", which are counted from 0");
      m_face.push_back(std::size_t(*index));
    }
    m_soup.polygons.add(m_face);
  }

  // What follows the last face would be lost in silence.
  void check_end()
  {
    if (const std::string_view line = next_line(m_lines); m_is_by_lines && !line.empty())
      throw Format_error(m_lines.line_number(), "goes on behind the " + std::to_string(m_vertices) + " vertices and " +
                                                  std::to_string(m_faces) + " faces that it announces: " + quote(line));
  }

  void begin(const char* what, std::size_t index)
  {
    if (!m_is_by_lines)
      return;
    m_words = next_line(m_lines);
    if (m_words.empty())
      end_too_early(what, index);
  }

  std::string_view next_word(const char* what, std::size_t index)
  {
    if (!m_is_by_lines)
      move_on_to_words();
    const std::string_view word = take_word(m_words);
    if (word.empty() && m_is_by_lines)
      throw Format_error(m_lines.line_number(),
                         std::string(what) + " " + std::to_string(index) + " is incomplete");
    if (word.empty())
      end_too_early(what, index);
    return word;
  }

  [[noreturn]] void end_too_early(const char* what, std::size_t index) const
  {
    throw Format_error("ends before " + std::string(what) + " " + std::to_string(index) + " of " +
                       std::to_string(*what == 'v' ? m_vertices : m_faces));
  }

  void move_on_to_words()
  {
    if (trim(m_words).empty())
      m_words = next_line(m_lines);
  }

  // The next one with anything in it; empty at the end.
  static std::string_view next_line(Lines& lines)
  {
    while (lines.next())
      if (const std::string_view line = without_comment(lines.line()); !line.empty())
        return line;
    return {};
  }

  Lines& m_lines;
  std::string_view m_words; // of the line, those that were not taken
  Keyword m_keyword;
  std::size_t m_vertices = 0;
  std::size_t m_faces = 0;
  bool m_is_by_lines = true;
  Polygon_soup m_soup;
  Polygon m_face; // the last one
};

bool begins_with_count(std::string_view line)
{
  return number<std::size_t>(take_word(line)).has_value();
}

} // namespace

Polygon_soup read_OFF(const std::string& bytes)
{
  Lines lines(bytes);
  std::string_view line;
  while (line.empty() && lines.next())
    line = without_comment(lines.line());
  const Keyword keyword = Keyword::take(line);
  if (!keyword.is_there && !begins_with_count(line))
    throw Format_error(lines.line_number(), "begins neither with OFF nor with a number: " + quote(line));
  if (trim(line) == "BINARY")
    return read_binary_OFF(lines.rest(), keyword.has_normals, keyword.has_colors);

  return OFF_reader(lines, keyword, line).take_soup();
}

} // namespace tool
