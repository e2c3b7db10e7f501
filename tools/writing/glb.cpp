// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/glb.h"

#include "writing/palette.h"
#include "writing/triangles.h"
#include "writing/unit_ball.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tool
{
namespace
{

using Json = nlohmann::ordered_json;

// What glTF calls things, from its specification, sections 3.6.2 and 3.7.2.
constexpr int array_buffer = 34962;
constexpr int element_array_buffer = 34963;
constexpr int type_float = 5126;
constexpr int type_unsigned_int = 5125;

// The triangles of one segment, with the vertices that they need.
struct Triangles
{
  std::vector<float> positions;
  std::vector<std::uint32_t> corners;
};

class Glb
{
public:
  explicit Glb(const Ball& ball)
  {
    m_json = {{"asset", {{"version", "2.0"}, {"generator", "segment_by_protrusions"}}},
              {"scene", 0},
              {"scenes", {{{"nodes", {0}}}}},
              // Positions are in single precision; this puts them where they are in the mesh.
              {"nodes", {{{"name", "mesh"},
                          {"translation", ball.center},
                          {"scale", {ball.radius, ball.radius, ball.radius}},
                          {"children", Json::array()}}}},
              {"meshes", Json::array()},
              {"materials", Json::array()},
              {"accessors", Json::array()},
              {"bufferViews", Json::array()}};
  }

  void add(std::size_t segment, const std::string& name, const Triangles& triangles)
  {
    const std::size_t material = append("materials", describe_material(segment, name));
    const Json primitive = {{"attributes", {{"POSITION", add_positions(triangles.positions)}}},
                            {"indices", add_corners(triangles.corners)},
                            {"material", material}};
    const std::size_t mesh = append("meshes", {{"name", name}, {"primitives", {primitive}}});
    const std::size_t node =
        append("nodes", {{"name", name}, {"mesh", mesh}, {"extras", {{"segment", segment}}}});
    m_json["nodes"][0]["children"].push_back(node);
  }

  void write(std::ostream& out)
  {
    m_json["buffers"] = {{{"byteLength", m_bytes.size()}}};
    std::string header = m_json.dump(-1, ' ', false, Json::error_handler_t::replace);
    header.resize((header.size() + 3) / 4 * 4, ' '); // chunks are multiples of four bytes
    out.write("glTF", 4);
    write_number(out, 2); // the version
    write_number(out, 12 + 8 + header.size() + 8 + m_bytes.size());
    write_chunk(out, "JSON", header);
    write_chunk(out, {"BIN\0", 4}, m_bytes);
  }

private:
  std::size_t append(const char* list, const Json& element)
  {
    m_json[list].push_back(element);
    return m_json[list].size() - 1;
  }

  static Json describe_material(std::size_t segment, const std::string& name)
  {
    const CGAL::IO::Color color = segment_color(segment);
    return {{"name", name},
            {"doubleSided", true},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {decode_sRGB(color.red()), decode_sRGB(color.green()),
                                   decode_sRGB(color.blue()), 1}},
              {"metallicFactor", 0},
              {"roughnessFactor", 0.8}}}};
  }

  template <typename T>
  std::size_t add_view(const std::vector<T>& numbers, int target)
  {
    const std::size_t begin = m_bytes.size();
    m_bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
    return append("bufferViews", {{"buffer", 0},
                                  {"byteOffset", begin},
                                  {"byteLength", m_bytes.size() - begin},
                                  {"target", target}});
  }

  std::size_t add_positions(const std::vector<float>& positions)
  {
    std::vector<float> low(positions.begin(), positions.begin() + 3), high = low;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      low[i % 3] = (std::min)(low[i % 3], positions[i]);
      high[i % 3] = (std::max)(high[i % 3], positions[i]);
    }
    return append("accessors", {{"bufferView", add_view(positions, array_buffer)},
                                {"componentType", type_float},
                                {"count", positions.size() / 3},
                                {"type", "VEC3"},
                                {"min", low},
                                {"max", high}});
  }

  std::size_t add_corners(const std::vector<std::uint32_t>& corners)
  {
    return append("accessors", {{"bufferView", add_view(corners, element_array_buffer)},
                                {"componentType", type_unsigned_int},
                                {"count", corners.size()},
                                {"type", "SCALAR"}});
  }

  static void write_number(std::ostream& out, std::size_t number)
  {
    const std::uint32_t word = static_cast<std::uint32_t>(number);
    out.write(reinterpret_cast<const char*>(&word), sizeof(word));
  }

  static void write_chunk(std::ostream& out, const std::string& type, const std::string& bytes)
  {
    write_number(out, bytes.size());
    out << type << bytes;
  }

  Json m_json;
  std::string m_bytes;
};

} // namespace

void write_GLB(std::ostream& out, const Segmented_soup& segmented)
{
  const Ball ball = bounding_ball(segmented.soup.points);
  const std::vector<float> positions = positions_in_unit_ball(segmented.soup.points, ball);
  std::map<std::size_t, std::vector<std::size_t>> faces_of;
  for (std::size_t face = 0; face < segmented.segments.size(); ++face)
    faces_of[segmented.segments[face]].push_back(face);

  Glb glb(ball);
  for (const auto& [segment, faces_of_segment] : faces_of)
  {
    Triangles triangles;
    std::map<std::size_t, std::uint32_t> indices; // of points
    const auto add_corner = [&](std::size_t point)
    {
      const std::uint32_t next = static_cast<std::uint32_t>(indices.size());
      const auto [position, is_new] = indices.emplace(point, next);
      if (is_new)
        triangles.positions.insert(triangles.positions.end(), positions.begin() + std::ptrdiff_t(3 * point),
                                   positions.begin() + std::ptrdiff_t(3 * point + 3));
      triangles.corners.push_back(position->second);
    };
    for (const std::size_t face : faces_of_segment)
      for_each_triangle(segmented.soup.polygons[face], [&](auto a, auto b, auto c) {
        add_corner(a);
        add_corner(b);
        add_corner(c);
      });
    if (!triangles.corners.empty())
      glb.add(segment, segmented.name_of(segment), triangles);
  }
  glb.write(out);
}

} // namespace tool
