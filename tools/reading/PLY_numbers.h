// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_PLY_NUMBERS_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_PLY_NUMBERS_H

#include "command_line/number.h"
#include "reading/Format_error.h"
#include "reading/Lines.h"
#include "reading/PLY_header.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace tool {
namespace PLY {

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

  // What follows the last element would be lost in silence. Binary files may have anything there.
  void check_end_of_text()
  {
    if (m_encoding != Encoding::text)
      return;
    m_position = (std::min)(m_bytes.find_first_not_of(any_separators, m_position), m_bytes.size());
    if (m_position < m_bytes.size())
      fail("goes on behind what the header announces");
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

} // namespace PLY
} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_PLY_NUMBERS_H
