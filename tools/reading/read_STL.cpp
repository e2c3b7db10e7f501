// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is text and what is binary is decided here, once: by the number of facets, which a binary file announces.
// CGAL's reader then gets something that can be read in one way only.

#include "reading/formats.h"

#include "command_line/number.h"
#include "reading/Normalized_text.h"

#include <CGAL/IO/STL.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace tool
{
namespace
{

constexpr std::size_t header_size = 80;
constexpr std::size_t facets_begin = header_size + 4; // behind their number
constexpr std::size_t facet_size = 50; // a normal and three vertices of three floats each, two bytes more
constexpr std::size_t normal_size = 12;

std::size_t announced_facets(const std::string& bytes)
{
  std::size_t number = 0;
  for (std::size_t i = facets_begin; i > header_size; --i)
    number = number << 8 | static_cast<unsigned char>(bytes[i - 1]);
  return number;
}

bool begins_with_solid(const std::string& bytes)
{
  std::string word;
  for (std::size_t i = bytes.find_first_not_of(" \t\r\n"); i < bytes.size() && word.size() < 5; ++i)
    word += static_cast<char>(std::tolower(static_cast<unsigned char>(bytes[i])));
  return word == "solid";
}

// Headers of binary files may begin with 'solid', too. Only these files have, behind the header, the zeros of a number
// below 2^24.
bool has_binary_number(const std::string& bytes)
{
  return bytes.size() >= facets_begin && bytes.find('\0', header_size) < facets_begin;
}

void check_coordinates(const std::string& bytes, std::size_t facet)
{
  std::array<float, 9> coordinates;
  std::memcpy(coordinates.data(), bytes.data() + facets_begin + facet * facet_size + normal_size,
              sizeof(coordinates));
  for (const float coordinate : coordinates)
    if (!std::isfinite(coordinate)) // no order of points has a place for it
      throw Format_error("facet " + std::to_string(facet) + " has no finite coordinates");
}

Polygon_soup read_binary(const std::string& bytes)
{
  if (bytes.size() < facets_begin)
    throw Format_error("is neither text in STL nor long enough for a binary one");
  const std::size_t facets = announced_facets(bytes);
  if (facets == 0)
    throw Format_error("has no faces");
  if (facets > (bytes.size() - facets_begin) / facet_size)
    throw Format_error("announces " + std::to_string(facets) + " facets, and ends after " +
                       std::to_string((bytes.size() - facets_begin) / facet_size));
  for (std::size_t i = 0; i < facets; ++i)
    check_coordinates(bytes, i);

  // Without the header, which may look like text, and without what comes behind the facets.
  std::istringstream in(std::string(header_size, '\0') +
                        bytes.substr(header_size, facets_begin - header_size + facets * facet_size));
  Polygon_soup soup;
  std::vector<Polygon> faces;
  if (!CGAL::IO::read_STL(in, soup.points, faces))
    throw Format_error("cannot be read");
  soup.polygons = polygons_of(faces);
  return soup;
}

// Keeps keywords and vertices, in small letters; names, which may be anything, are left out.
class STL_normalizer
{
public:
  explicit STL_normalizer(const std::string& text)
  {
    for (Lines lines(text); lines.next();)
    {
      m_line = lines.line_number();
      std::string line(lines.line());
      std::transform(line.begin(), line.end(), line.begin(),
                     [](unsigned char c) { return char(std::tolower(c)); });
      add_words(line);
    }
    if (m_is_in_facet)
      throw Format_error("ends within a facet");
    if (m_is_in_solid)
      throw Format_error("ends without 'endsolid'");
    if (m_facets == 0)
      throw Format_error("has no faces");
  }

  const Normalized_text& text() const { return m_text; }

private:
  void add_words(std::string_view words)
  {
    for (std::string_view word = take_word(words); !word.empty(); word = take_word(words))
    {
      if (word == "end") // of 'end facet'
        word = take_word(words) == "facet" ? "endfacet" : "";
      if (word == "solid" || word == "endsolid")
      {
        m_is_in_solid = word == "solid";
        add(word);
        words.remove_prefix((std::min)(words.find("facet normal"), words.size()));
      }
      else if (word == "facet")
        begin_facet();
      else if (word == "vertex")
        add_vertex(words);
      else if (word == "endfacet")
        end_facet();
    }
  }

  void add(std::string_view line)
  {
    m_text << line;
    m_text.end_line(m_line);
  }

  void begin_facet()
  {
    if (m_is_in_facet)
      throw Format_error(m_line, "a facet begins within another one");
    if (!m_is_in_solid)
      throw Format_error(m_line, "a facet begins outside of a solid");
    m_is_in_facet = true;
    m_vertices = 0;
    ++m_facets;
    add("facet");
  }

  void add_vertex(std::string_view& words)
  {
    if (!m_is_in_facet)
      throw Format_error(m_line, "a vertex is outside of a facet");
    ++m_vertices;
    m_text << "vertex";
    for (int i = 0; i < 3; ++i)
      m_text << " " << take_coordinate(words);
    m_text.end_line(m_line);
  }

  // CGAL's reader would not tell which line it stops at.
  std::string_view take_coordinate(std::string_view& words) const
  {
    const std::string_view word = take_word(words);
    double coordinate = 0;
    const std::errc error = parse_number(word, coordinate); // one out of range may be 0
    if (error == std::errc::invalid_argument || !std::isfinite(coordinate))
      throw Format_error(m_line, quote(word) + " is no coordinate");
    return word;
  }

  void end_facet()
  {
    if (m_vertices != 3)
      throw Format_error(m_line, "a facet has " + std::to_string(m_vertices) + " vertices");
    m_is_in_facet = false;
    add("endfacet");
  }

  Normalized_text m_text;
  std::size_t m_line = 0;
  std::size_t m_facets = 0;
  std::size_t m_vertices = 0; // of the facet
  bool m_is_in_facet = false;
  bool m_is_in_solid = false;
};

} // namespace

bool is_binary_STL(const std::string& bytes)
{
  return bytes.size() >= facets_begin && facets_begin + announced_facets(bytes) * facet_size == bytes.size();
}

Polygon_soup read_STL(const std::string& bytes)
{
  if (is_binary_STL(bytes) || !begins_with_solid(bytes) || has_binary_number(bytes))
    return read_binary(bytes);
  Polygon_soup soup;
  std::vector<Polygon> faces;
  STL_normalizer(bytes).text().read_by([&](std::istream& in) { return CGAL::IO::read_STL(in, soup.points, faces); });
  soup.polygons = polygons_of(faces);
  return soup;
}

} // namespace tool
