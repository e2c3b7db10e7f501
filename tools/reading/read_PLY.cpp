// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's reader of PLY takes counts on trust, crashes on a property without element, takes the bytes of an unknown
// type for others, and knows no triangle strips. To guard it, a file had to be walked through to its end; this takes the
// vertices and faces along, and needs no second reader.

#include "reading/formats.h"

#include "command_line/number.h"
#include "reading/Format_error.h"
#include "reading/Lines.h"
#include "reading/PLY_header.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tool {
namespace {

using namespace PLY;

// The numbers behind the header, one after the other.
class Numbers
{
public:
  Numbers(const std::string& bytes, std::size_t begin, std::size_t line, Encoding encoding)
    : m_bytes(bytes),
      m_position(begin),
      m_begin(begin),
      m_line(line),
      m_encoding(encoding)
  {}

  // From now on every element has a line of its own, and what is left of the line does not matter.
  void go_by_lines() { m_separators = " \t\v\f"; }

  // Where an element begins.
  void begin_element()
  {
    if (m_separators != any_separators)
      m_position = (std::min)(m_bytes.find_first_not_of(any_separators, m_position), m_bytes.size());
  }

  // Where it ends.
  void end_element()
  {
    if (m_separators != any_separators)
      m_position = (std::min)(m_bytes.find_first_of("\r\n", m_position), m_bytes.size());
  }

  double take(const Type& type) { return m_encoding == Encoding::text ? take_word() : take_binary(type); }

  // A number of values in a list. Each takes a byte at least.
  std::size_t take_count(const Type& type)
  {
    const double count = take(type);
    if (!(count >= 0 && count <= double(m_bytes.size() - m_position)))
      fail("a list announces more than the file can hold");
    return static_cast<std::size_t>(count);
  }

  std::size_t take_index(const Type& type)
  {
    const double index = take(type);
    if (!(index >= 0 && index < 4294967296. && index == double(std::size_t(index))))
      fail("a face names vertex " + std::to_string(index));
    return static_cast<std::size_t>(index);
  }

  [[noreturn]] void fail(const std::string& cause) const
  {
    if (m_encoding != Encoding::text)
      throw Format_error("byte " + std::to_string(m_position) + ": " + cause);
    const auto begin = m_bytes.begin() + std::ptrdiff_t(m_begin);
    const auto end = m_bytes.begin() + std::ptrdiff_t(m_position);
    throw Format_error(m_line + 1 + std::size_t(std::count(begin, end, '\n')), cause);
  }

private:
  double take_word()
  {
    const std::size_t begin = m_bytes.find_first_not_of(m_separators, m_position);
    if (begin == std::string::npos)
      throw Format_error("ends too early");
    m_position = (std::min)(m_bytes.find_first_of(any_separators, begin), m_bytes.size());
    if (m_position == begin)
      fail("has fewer numbers than the header says");
    const std::string_view word(m_bytes.data() + begin, m_position - begin);
    const auto value = number<double>(word);
    if (!value)
      fail(quote(word) + " is no number");
    return *value;
  }

  double take_binary(const Type& type)
  {
    if (m_bytes.size() - m_position < type.size)
      throw Format_error("ends too early");
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.size; ++i)
    {
      const std::size_t place = m_encoding == Encoding::largest_byte_first ? i : type.size - 1 - i;
      bits = bits << 8 | static_cast<unsigned char>(m_bytes[m_position + place]);
    }
    m_position += type.size;
    if (type.kind == 'u')
      return double(bits);
    if (type.kind == 'i')
    {
      const std::uint64_t sign = std::uint64_t(1) << (8 * type.size - 1);
      return double(bits) - ((bits & sign) != 0 ? 2 * double(sign) : 0);
    }
    return type.size == 4 ? as<float>(std::uint32_t(bits)) : as<double>(bits);
  }

  template <typename Float, typename Bits>
  static double as(Bits bits)
  {
    static_assert(sizeof(Float) == sizeof(Bits));
    Float value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }

  static constexpr std::string_view any_separators = " \t\v\f\r\n";

  const std::string& m_bytes;
  std::string_view m_separators = any_separators; // of the numbers of an element
  std::size_t m_position;
  std::size_t m_begin;
  std::size_t m_line; // that of the header's end
  Encoding m_encoding;
};

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
      read(element, numbers);
    if (m_soup.polygons.empty())
      throw Format_error(has("range_grid")
                           ? "is a range grid, the depths that a scanner saw, without faces"
                           : "has no faces");
  }

  Polygon_soup take_soup() { return std::move(m_soup); }
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

  void read(const Element& element, Numbers& numbers)
  {
    if (element.properties.empty())
      return;
    if (element.name == "vertex")
      check_coordinates(element);
    for (std::size_t i = 0; i < element.count; ++i)
    {
      std::array<double, 3> point = {0, 0, 0};
      numbers.begin_element();
      for (const Property& property : element.properties)
        read(element, property, numbers, point);
      numbers.end_element();
      if (element.name == "vertex")
        m_soup.points.emplace_back(point[0], point[1], point[2]);
    }
  }

  static void check_coordinates(const Element& vertex)
  {
    for (const std::string coordinate : {"x", "y", "z"})
      if (std::none_of(vertex.properties.begin(), vertex.properties.end(),
                       [&](const Property& property)
                       { return property.name == coordinate && !property.count_type; }))
        throw Format_error("its vertices have no property " + coordinate);
  }

  void read(const Element& element,
            const Property& property,
            Numbers& numbers,
            std::array<double, 3>& point)
  {
    const bool is_coordinate = property.name.size() == 1 && property.name[0] >= 'x' &&
                               property.name[0] <= 'z';
    const bool is_corners = property.name == "vertex_indices" || property.name == "vertex_index";
    if (!property.count_type)
    {
      const double value = numbers.take(property.type);
      if (is_coordinate)
        point[std::size_t(property.name[0] - 'x')] = value;
      else if (element.name == "face" && is_label(property.name))
        m_labels.push_back(value);
    }
    else if (is_corners && element.name == "face")
      read_face(property, numbers);
    else if (is_corners && element.name == "tristrips")
      read_strips(property, numbers);
    else
      for (std::size_t left = numbers.take_count(*property.count_type); left > 0; --left)
        numbers.take(property.type);
  }

  void read_face(const Property& property, Numbers& numbers)
  {
    m_face.clear(); // what it has room for stays
    for (std::size_t left = numbers.take_count(*property.count_type); left > 0; --left)
      m_face.push_back(numbers.take_index(property.type));
    m_soup.polygons.push_back(m_face);
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
        m_soup.polygons.push_back(triangle_of_strip(strip, strip.size()));
    }
  }

  Lines m_lines;
  Header m_header;
  Polygon_soup m_soup;
  Polygon m_face; // the last one
  std::vector<double> m_labels;
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
