// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walks through a PLY file before CGAL's reader does. That takes on trust that vertices have
// coordinates and that the file holds as much as it announces.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_CHECK_PLY_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_CHECK_PLY_H

#include "command_line/Error.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace tool
{

class PLY_checker
{
public:
  explicit PLY_checker(const std::string& file_name)
    : m_file_name(file_name), m_in(file_name, std::ios::binary),
      m_file_size(std::filesystem::file_size(file_name))
  { }

  // Throws an `Error` for what only this class looks for; leaves other errors to CGAL's reader.
  void check()
  {
    read_header();
    check_coordinates();
    for (const Element& element : m_elements)
      for (std::uint64_t i = 0; i < element.count; ++i)
        for (const Property& property : element.properties)
          skip_values(property.count_size > 0 ? read_count(property) : 1, property.size);
  }

private:
  struct Property
  {
    std::string name;
    std::size_t size;       // of a value, in bytes
    std::size_t count_size; // of the number of values in a list; 0 if there is no list
  };
  struct Element
  {
    std::string name;
    std::uint64_t count;
    std::vector<Property> properties;
  };

  // Throws if the file cannot hold `count` values of at least one byte.
  void check_count(std::uint64_t count) const
  {
    if (count > m_file_size)
      throw Error(m_file_name, "announces more than it can hold");
  }

  static std::size_t size_of_type(const std::string& type)
  {
    static const std::map<std::string, std::size_t> sizes =
      {{"char", 1}, {"int8", 1}, {"uchar", 1}, {"uint8", 1}, {"short", 2}, {"int16", 2},
       {"ushort", 2}, {"uint16", 2}, {"int", 4}, {"int32", 4}, {"uint", 4}, {"uint32", 4},
       {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto found = sizes.find(type);
    return found == sizes.end() ? 0 : found->second;
  }

  // CGAL's reader skips a property of a type that it does not know, and takes its bytes for others.
  void read_header()
  {
    for (std::string line; std::getline(m_in, line);)
    {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "end_header")
        return;
      if (keyword == "format")
        words >> m_format;
      else if (keyword == "element")
      {
        Element element;
        if (!(words >> element.name >> element.count))
          refuse();
        check_count(element.count);
        m_elements.push_back(element);
      }
      else if (keyword == "property")
        read_property(words);
    }
    refuse(); // no end_header
  }

  void read_property(std::istringstream& words)
  {
    std::string type, count_type, name;
    words >> type;
    if (type == "list")
      words >> count_type >> type;
    words >> name;
    const Property property = {name, size_of_type(type), size_of_type(count_type)};
    if (!words || m_elements.empty() || property.size == 0 ||
       (!count_type.empty() && property.count_size == 0))
      refuse();
    m_elements.back().properties.push_back(property);
  }

  [[noreturn]] void refuse() const { throw Error(m_file_name, "is not a well-formed mesh file"); }

  void check_coordinates() const
  {
    for (const Element& element : m_elements)
      if (element.name == "vertex")
        for (const std::string coordinate : {"x", "y", "z"})
        {
          bool is_found = false;
          for (const Property& property : element.properties)
            is_found = is_found || property.name == coordinate;
          if (!is_found)
            throw Error(m_file_name, "its vertices have no property " + coordinate);
        }
  }

  std::uint64_t read_count(const Property& property)
  {
    std::uint64_t count = 0;
    if (m_format == "ascii")
      m_in >> count;
    else
      for (std::size_t i = 0; i < property.count_size; ++i)
      {
        const std::uint64_t byte = static_cast<unsigned char>(m_in.get());
        count = m_format == "binary_big_endian" ? (count << 8 | byte) : (count | byte << 8 * i);
      }
    check_count(count);
    return count;
  }

  void skip_values(std::uint64_t number, std::size_t size)
  {
    std::string word;
    if (m_format == "ascii")
      for (std::uint64_t i = 0; i < number && m_in; ++i)
        m_in >> word;
    else if (number > 0)
      m_in.ignore(static_cast<std::streamsize>(number * size));
    if (!m_in || (number > 0 && m_in.eof() && m_format != "ascii"))
      throw Error(m_file_name, "ends too early");
  }

  std::string m_file_name;
  std::ifstream m_in;
  std::uint64_t m_file_size;
  std::string m_format;
  std::vector<Element> m_elements;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_CHECK_PLY_H
