// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_PLY_HEADER_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_PLY_HEADER_H

#include "command_line/number.h"
#include "reading/Format_error.h"
#include "reading/Lines.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tool
{
namespace PLY
{

enum class Encoding
{
  text,
  smallest_byte_first,
  largest_byte_first
};

struct Type
{
  char kind;        // i: signed integer, u: unsigned integer, f: floating-point number
  std::size_t size; // in bytes; 0 if there is no such type
};

inline Type type_of_name(std::string_view name)
{
  static const std::map<std::string_view, Type> types = {
    {"char", {'i', 1}},  {"int8", {'i', 1}},    {"uchar", {'u', 1}},  {"uint8", {'u', 1}},
    {"short", {'i', 2}}, {"int16", {'i', 2}},   {"ushort", {'u', 2}}, {"uint16", {'u', 2}},
    {"int", {'i', 4}},   {"int32", {'i', 4}},   {"uint", {'u', 4}},   {"uint32", {'u', 4}},
    {"float", {'f', 4}}, {"float32", {'f', 4}}, {"double", {'f', 8}}, {"float64", {'f', 8}}};
  const auto found = types.find(name);
  return found == types.end() ? Type{'u', 0} : found->second;
}

struct Property
{
  std::string name;
  Type type;
  std::optional<Type> count_type; // of a list
};

struct Element
{
  std::string name;
  std::size_t count;
  std::vector<Property> properties;
};

struct Header
{
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;

  // Reads all lines up to "end_header".
  explicit Header(Lines& lines)
  {
    if (!lines.next() || trim(lines.line()) != "ply")
      throw Format_error(lines.line_number(), "does not begin with 'ply'");
    bool has_format = false;
    while (lines.next())
    {
      std::string_view words = lines.line();
      const std::string_view keyword = take_word(words);
      if (keyword == "end_header" && has_format)
        return;
      if (keyword == "format")
        has_format = read_format(words);
      const bool is_good = keyword == "element"    ? add_element(words, lines.rest().size())
                           : keyword == "property" ? add_property(words)
                                                   : is_known(keyword);
      if (!is_good)
        throw Format_error(lines.line_number(), "cannot make sense of " + quote(lines.line()));
    }
    throw Format_error("has no complete header");
  }

private:
  static bool is_known(std::string_view keyword)
  {
    return keyword == "format" || keyword == "comment" || keyword == "obj_info" || keyword.empty();
  }

  bool read_format(std::string_view words)
  {
    const std::string_view name = take_word(words);
    encoding = name == "binary_little_endian" ? Encoding::smallest_byte_first
               : name == "binary_big_endian"  ? Encoding::largest_byte_first
                                              : Encoding::text;
    if (encoding == Encoding::text && name != "ascii")
      throw Format_error("is in the unknown encoding " + quote(name));
    return true;
  }

  bool add_element(std::string_view words, std::size_t bytes_left)
  {
    const std::string_view name = take_word(words);
    const auto count = number<std::size_t>(take_word(words));
    if (!count)
      return false;
    if (*count > bytes_left)
      throw Format_error("announces more of the element " + quote(name) + " than it can hold");
    elements.push_back({std::string(name), *count, {}});
    return true;
  }

  bool add_property(std::string_view words)
  {
    std::string_view type = take_word(words);
    std::optional<Type> count_type;
    if (type == "list")
    {
      count_type = type_of_name(take_word(words));
      type = take_word(words);
    }
    const Property property = {std::string(take_word(words)), type_of_name(type), count_type};
    const bool is_good = !elements.empty() && property.type.size > 0 && !property.name.empty() &&
                         (!count_type || count_type->size > 0);
    if (is_good)
      elements.back().properties.push_back(property);
    return is_good;
  }
};

} // namespace PLY
} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_PLY_HEADER_H
