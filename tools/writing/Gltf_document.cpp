// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Gltf_document.h"

#include "report/base64.h"
#include "writing/binary_numbers.h"
#include "writing/palette.h"

#include <algorithm>
#include <sstream>
#include <type_traits>

namespace tool {
namespace {

// What glTF calls things, from its specification, sections 3.6.2 and 3.7.2.
constexpr int array_buffer = 34962, element_array_buffer = 34963, no_target = 0;
constexpr int type_float = 5126, type_unsigned_short = 5123, type_unsigned_int = 5125;

void write_chunk(std::ostream& out, const std::string& type, const std::string& bytes)
{
  write_bits(out, static_cast<std::uint32_t>(bytes.size()));
  out << type << bytes;
}

void write_number(std::ostream& out, float number)
{
  write_float(out, number);
}
template <typename Integer>
void write_number(std::ostream& out, Integer number)
{
  write_bits(out, number);
}

} // namespace

Gltf_document::Gltf_document()
  : m_json({{"asset", {{"version", "2.0"}, {"generator", "segment_by_protrusions"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", Json::array()}}}}})
{}

std::size_t Gltf_document::append(const char* list, const Json& element)
{
  m_json[list].push_back(element);
  return m_json[list].size() - 1;
}

template <typename T>
std::size_t Gltf_document::add_view(const std::vector<T>& numbers, int target)
{
  static_assert(sizeof(T) == 4 || std::is_same_v<T, std::uint16_t>); // four of these
  std::ostringstream bytes;
  for (const T number : numbers)
    write_number(bytes, number);
  const std::size_t begin = m_bytes.size();
  m_bytes += bytes.str();
  Json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", m_bytes.size() - begin}};
  if (target != no_target)
    view["target"] = target;
  return append("bufferViews", view);
}

std::size_t Gltf_document::add_floats(const std::vector<float>& numbers,
                                      std::size_t dimension,
                                      bool has_bounds)
{
  const char* const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  Json accessor = {{"bufferView", add_view(numbers, array_buffer)},
                   {"componentType", type_float},
                   {"count", numbers.size() / dimension},
                   {"type", types[dimension - 1]}};
  if (has_bounds)
  {
    std::vector<float> low(numbers.begin(), numbers.begin() + std::ptrdiff_t(dimension)), high = low;
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      low[i % dimension] = (std::min)(low[i % dimension], numbers[i]);
      high[i % dimension] = (std::max)(high[i % dimension], numbers[i]);
    }
    accessor["min"] = low;
    accessor["max"] = high;
  }
  return append("accessors", accessor);
}

std::size_t Gltf_document::add_joints(const std::vector<std::uint16_t>& joints)
{
  return append("accessors", {{"bufferView", add_view(joints, array_buffer)},
                              {"componentType", type_unsigned_short},
                              {"count", joints.size() / 4},
                              {"type", "VEC4"}});
}

std::size_t Gltf_document::add_matrices(const std::vector<float>& numbers)
{
  return append("accessors", {{"bufferView", add_view(numbers, no_target)},
                              {"componentType", type_float},
                              {"count", numbers.size() / 16},
                              {"type", "MAT4"}});
}

std::size_t Gltf_document::add_corners(const std::vector<std::uint32_t>& corners)
{
  return append("accessors", {{"bufferView", add_view(corners, element_array_buffer)},
                              {"componentType", type_unsigned_int},
                              {"count", corners.size()},
                              {"type", "SCALAR"}});
}

std::size_t Gltf_document::add_material(std::size_t segment, const std::string& name, bool is_white)
{
  const CGAL::IO::Color color = is_white ? CGAL::IO::white() : segment_color(segment);
  return append("materials",
                {{"name", name},
                 {"doubleSided", true},
                 {"pbrMetallicRoughness",
                  {{"baseColorFactor",
                    {decode_sRGB(color.red()), decode_sRGB(color.green()), decode_sRGB(color.blue()), 1}},
                   {"metallicFactor", 0},
                   {"roughnessFactor", 0.8}}}});
}

std::size_t Gltf_document::add_picture(const std::string& bytes, const std::string& mime_type)
{
  constexpr std::size_t alignment = 4; // of what comes behind
  const Json view = {{"buffer", 0}, {"byteOffset", m_bytes.size()}, {"byteLength", bytes.size()}};
  m_bytes += bytes;
  m_bytes.resize((m_bytes.size() + alignment - 1) / alignment * alignment, '\0');
  return append("images", {{"bufferView", append("bufferViews", view)}, {"mimeType", mime_type}});
}

void Gltf_document::use_extension(const std::string& name, bool is_required)
{
  const auto add = [&](const char* list)
  {
    const Json known = m_json.value(list, Json::array());
    if (std::find(known.begin(), known.end(), name) == known.end())
      append(list, name);
  };
  add("extensionsUsed");
  if (is_required)
    add("extensionsRequired");
}

std::string Gltf_document::text_with_buffer(const Json& buffer, int indentation) const
{
  Json json = m_json;
  json["buffers"] = Json::array({buffer});
  // A name that is no UTF-8 must not keep the rest from being written.
  return json.dump(indentation, ' ', false, Json::error_handler_t::replace);
}

void Gltf_document::write_binary(std::ostream& out) const
{
  constexpr std::size_t alignment = 4, size_of_headers = 12 + 8 + 8; // of the file and of two chunks
  std::string header = text_with_buffer({{"byteLength", m_bytes.size()}}, -1);
  header.resize((header.size() + alignment - 1) / alignment * alignment, ' ');
  out << "glTF";
  write_bits(out, std::uint32_t(2)); // the version
  write_bits(out, static_cast<std::uint32_t>(size_of_headers + header.size() + m_bytes.size()));
  write_chunk(out, "JSON", header);
  write_chunk(out, {"BIN\0", 4}, m_bytes);
}

void Gltf_document::write_text(std::ostream& out) const
{
  const std::vector<char> bytes(m_bytes.begin(), m_bytes.end());
  out << text_with_buffer({{"byteLength", bytes.size()},
                           {"uri", "data:application/octet-stream;base64," + base64(bytes)}},
                          1)
      << "\n";
}

} // namespace tool
