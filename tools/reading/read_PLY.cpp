// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's reader of PLY takes counts on trust, crashes on a property without element, takes the bytes of an unknown
// type for others, and knows no triangle strips. To guard it, a file had to be walked through to its end; this takes the
// vertices and faces along, and needs no second reader.

#include "reading/formats.h"

#include "reading/Format_error.h"
#include "reading/Lines.h"
#include "reading/PLY_attributes.h"
#include "reading/PLY_header.h"
#include "reading/PLY_numbers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tool {
namespace {

using namespace PLY;

class PLY_reader
{
public:
  explicit PLY_reader(const std::string& bytes) : m_lines(bytes), m_header(m_lines)
  {
    Numbers numbers(bytes, bytes.size() - m_lines.rest().size(), m_lines.line_number(),
                    m_header.encoding);
    if (m_header.encoding == Encoding::text && has_a_line_for_each_element())
      numbers.go_by_lines();
    for (const Element& element : m_header.elements)
      if (element.name == "vertex")
        read_vertices(element, numbers);
      else
        read(element, numbers);
    numbers.check_end_of_text();
    if (m_soup.polygons.empty())
      throw Format_error(has("range_grid")
                           ? "is a range grid, the depths that a scanner saw, without faces"
                           : "has no faces");
  }

  Polygon_soup take_soup()
  {
    if (m_attributes)
      m_soup.attributes = m_attributes->take(m_soup);
    return std::move(m_soup);
  }
  std::vector<double> take_labels() { return std::move(m_labels); }

private:
  bool has(const std::string& name) const
  {
    return std::any_of(m_header.elements.begin(), m_header.elements.end(),
                       [&](const Element& element) { return element.name == name; });
  }

  // As the format asks for. Other files are read number by number.
  bool has_a_line_for_each_element() const
  {
    std::size_t elements = 0, lines_with_text = 0;
    for (const Element& element : m_header.elements)
      elements += element.properties.empty() ? 0 : element.count;
    for (Lines lines(m_lines.rest()); lines.next();)
      lines_with_text += trim(lines.line()).empty() ? 0 : 1;
    return lines_with_text == elements;
  }

  // A list has no value.
  void read_vertices(const Element& vertex, Numbers& numbers)
  {
    if (vertex.properties.empty())
      return;
    check_coordinates(vertex);
    Attributes attributes(vertex);
    std::vector<double> values(vertex.properties.size(), 0);
    std::array<std::size_t, 3> places = {0, 0, 0}; // of the coordinates
    for (std::size_t i = 0; i < values.size(); ++i)
      if (const std::string& name = vertex.properties[i].name;
          name.size() == 1 && name[0] >= 'x' && name[0] <= 'z')
        places[std::size_t(name[0] - 'x')] = i;
    for (std::size_t i = 0; i < vertex.count; ++i)
    {
      numbers.begin_element();
      for (std::size_t k = 0; k < values.size(); ++k)
        if (const Property& property = vertex.properties[k]; property.count_type)
          skip_list(property, numbers);
        else
          values[k] = numbers.take(property.type);
      numbers.end_element();
      m_soup.points.emplace_back(values[places[0]], values[places[1]], values[places[2]]);
      attributes.add_vertex(values);
    }
    m_attributes.emplace(std::move(attributes));
  }

  void read(const Element& element, Numbers& numbers)
  {
    if (element.properties.empty())
      return;
    for (std::size_t i = 0; i < element.count; ++i)
    {
      numbers.begin_element();
      for (const Property& property : element.properties)
        read(element, property, numbers);
      numbers.end_element();
    }
  }

  static void skip_list(const Property& property, Numbers& numbers)
  {
    for (std::size_t left = numbers.take_count(*property.count_type); left > 0; --left)
      numbers.take(property.type);
  }

  static void check_coordinates(const Element& vertex)
  {
    for (const std::string coordinate : {"x", "y", "z"})
      if (std::none_of(vertex.properties.begin(), vertex.properties.end(),
                       [&](const Property& property)
                       { return property.name == coordinate && !property.count_type; }))
        throw Format_error("its vertices have no property " + coordinate);
  }

  void read(const Element& element, const Property& property, Numbers& numbers)
  {
    const bool is_corners = property.name == "vertex_indices" || property.name == "vertex_index";
    if (!property.count_type)
    {
      const double value = numbers.take(property.type);
      if (element.name == "face" && is_label(property.name))
        m_labels.push_back(value);
    }
    else if (is_corners && element.name == "face")
      read_face(property, numbers);
    else if (is_corners && element.name == "tristrips")
      read_strips(property, numbers);
    else
      skip_list(property, numbers);
  }

  void read_face(const Property& property, Numbers& numbers)
  {
    m_face.clear(); // what it has room for stays
    for (std::size_t left = numbers.take_count(*property.count_type); left > 0; --left)
      m_face.push_back(numbers.take_index(property.type));
    m_soup.polygons.add(m_face);
  }

  // -1 begins a new strip.
  void read_strips(const Property& property, Numbers& numbers)
  {
    Polygon strip;
    for (std::size_t left = numbers.take_count(*property.count_type); left > 0; --left)
    {
      const double value = numbers.take(property.type);
      if (value == -1)
      {
        strip.clear();
        continue;
      }
      if (!(value >= 0 && value < 4294967296.))
        numbers.fail("a strip names vertex " + std::to_string(value));
      strip.push_back(static_cast<std::size_t>(value));
      if (strip.size() >= 3)
        m_soup.polygons.add(triangle_of_strip(strip, strip.size()));
    }
  }

  Lines m_lines;
  Header m_header;
  Polygon_soup m_soup;
  Polygon m_face; // the last one
  std::vector<double> m_labels;
  std::optional<Attributes> m_attributes;
};

} // namespace

Polygon_soup read_PLY(const std::string& bytes)
{
  return PLY_reader(bytes).take_soup();
}

std::vector<double> read_PLY_labels(const std::string& bytes)
{
  return PLY_reader(bytes).take_labels();
}

} // namespace tool
