// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is text and what is binary is decided by the number of facets, which a binary file announces.

#include "reading/formats.h"

#include "command_line/number.h"
#include "reading/Format_error.h"
#include "reading/Lines.h"

#include <boost/functional/hash.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

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

// Triangles of a file that names no points: corners with the same coordinates are one point.
class Triangles
{
public:
  void add_corner(const std::array<double, 3>& corner)
  {
    const auto [place, is_new] = m_numbers.try_emplace(corner, m_soup.points.size());
    if (is_new)
      m_soup.points.emplace_back(corner[0], corner[1], corner[2]);
    m_corners.push_back(place->second);
  }

  // How many corners were added since the last triangle.
  std::size_t number_of_corners() const { return m_corners.size(); }
  void end_triangle()
  {
    m_soup.polygons.add(m_corners);
    m_corners.clear();
  }

  Polygon_soup take_soup() { return std::move(m_soup); }

private:
  Polygon_soup m_soup;
  Polygon m_corners; // of the next triangle
  boost::unordered_map<std::array<double, 3>, std::size_t> m_numbers; // of the points
};

// 0 and -0 are one coordinate.
double coordinate(double x)
{
  return x + 0.;
}

void add_facet(const std::string& bytes, std::size_t facet, Triangles& triangles)
{
  std::array<float, 9> coordinates;
  std::memcpy(coordinates.data(), bytes.data() + facets_begin + facet * facet_size + normal_size,
              sizeof(coordinates));
  for (const float x : coordinates)
    if (!std::isfinite(x))
      throw Format_error("facet " + std::to_string(facet) + " has no finite coordinates");
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
    triangles.add_corner({coordinate(coordinates[i]), coordinate(coordinates[i + 1]), coordinate(coordinates[i + 2])});
  triangles.end_triangle();
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
  Triangles triangles;
  for (std::size_t i = 0; i < facets; ++i)
    add_facet(bytes, i, triangles);
  return triangles.take_soup();
}

// Looks at keywords and vertices, in small and capital letters; names, which may be anything, are left out.
class STL_text
{
public:
  explicit STL_text(const std::string& text)
  {
    std::string line; // in small letters
    for (Lines lines(text); lines.next();)
    {
      m_line = lines.line_number();
      line.assign(lines.line());
      std::transform(line.begin(), line.end(), line.begin(),
                     [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
      read_words(line);
    }
    if (m_is_in_facet)
      throw Format_error("ends within a facet");
    if (m_is_in_solid)
      throw Format_error("ends without 'endsolid'");
    if (!m_has_facets)
      throw Format_error("has no faces");
  }

  Polygon_soup take_soup() { return m_triangles.take_soup(); }

private:
  void read_words(std::string_view words)
  {
    for (std::string_view word = take_word(words); !word.empty(); word = take_word(words))
    {
      if (word == "end") // of 'end facet'
        word = take_word(words) == "facet" ? "endfacet" : "";
      if (word == "solid" || word == "endsolid")
      {
        m_is_in_solid = word == "solid";
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

  void begin_facet()
  {
    if (m_is_in_facet)
      throw Format_error(m_line, "a facet begins within another one");
    if (!m_is_in_solid)
      throw Format_error(m_line, "a facet begins outside of a solid");
    m_is_in_facet = true;
    m_has_facets = true;
  }

  void add_vertex(std::string_view& words)
  {
    if (!m_is_in_facet)
      throw Format_error(m_line, "a vertex is outside of a facet");
    std::array<double, 3> corner;
    for (double& x : corner)
      x = take_coordinate(words);
    m_triangles.add_corner(corner);
  }

  double take_coordinate(std::string_view& words) const
  {
    const std::string_view word = take_word(words);
    double x = 0; // stays if a number is too small
    const std::errc error = parse_number(word, x);
    const bool is_too_small = error == std::errc::result_out_of_range && word.find("e-") != word.npos;
    if ((error != std::errc() && !is_too_small) || !std::isfinite(x))
      throw Format_error(m_line, quote(word) + " is no coordinate");
    return coordinate(x);
  }

  void end_facet()
  {
    if (m_triangles.number_of_corners() != 3)
      throw Format_error(m_line, "a facet has " + std::to_string(m_triangles.number_of_corners()) + " vertices");
    m_triangles.end_triangle();
    m_is_in_facet = false;
  }

  Triangles m_triangles;
  std::size_t m_line = 0;
  bool m_has_facets = false;
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
  return STL_text(bytes).take_soup();
}

} // namespace tool
