// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/gltf_primitives.h"

#include "writing/Copied_materials.h"
#include "writing/corner_normals.h"
#include "writing/palette.h"
#include "writing/triangles.h"
#include "writing/unit_ball.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

namespace tool {
namespace {

using Json = Gltf_document::Json;

// What a mesh in glTF has for each vertex: points are there once for each of their normals and texture coordinates.
class Vertices
{
public:
  // `has_texture` says whether some corners have texture coordinates; those of the others are zero then.
  Vertices(const Polygon_soup& soup, const Gltf_frame& frame, bool has_texture, bool has_colors)
    : m_soup(soup),
      m_frame(frame),
      m_has_texture(has_texture),
      m_has_colors(has_colors)
  {}

  std::uint32_t add(std::size_t face, std::size_t corner, const Normal& normal)
  {
    const std::size_t point = m_soup.polygons[face][corner];
    const Corner_values<2>& textures = m_soup.attributes.texture_coordinates;
    const std::size_t texture = m_has_texture && textures.has(face) ? textures.indices[face][corner]
                                                                    : no_index;
    const auto next = static_cast<std::uint32_t>(m_points.size());
    const auto [known, is_new] = m_last_of_point.emplace(point, next);
    if (!is_new)
    {
      std::uint32_t vertex = known->second;
      while (vertex != none &&
             (m_textures_of_vertices[vertex] != texture || m_normals_of_vertices[vertex] != normal))
        vertex = m_earlier[vertex];
      if (vertex != none)
        return vertex;
    }
    m_earlier.push_back(is_new ? none : known->second);
    known->second = next;
    m_points.push_back(point);
    m_textures_of_vertices.push_back(texture);
    m_normals_of_vertices.push_back(normal);
    const std::array<float, 3> coordinates = m_frame.position(m_soup.points[point]);
    m_positions.insert(m_positions.end(), coordinates.begin(), coordinates.end());
    m_normals.insert(m_normals.end(), normal.begin(), normal.end());
    if (m_has_texture)
    {
      const std::array<double, 2> value = texture == no_index ? std::array<double, 2>{0, 0}
                                                              : textures.values[texture];
      m_textures.push_back(static_cast<float>(value[0]));
      m_textures.push_back(static_cast<float>(1 - value[1])); // glTF counts downwards
    }
    if (m_has_colors)
      add_color(m_soup.attributes.colors[point]);
    return next;
  }

  // Of each vertex.
  const std::vector<std::size_t>& points() const { return m_points; }

  Json add_attributes(std::size_t segment, Gltf_document& document) const
  {
    constexpr bool has_bounds = true;
    Json result = {{"POSITION", document.add_floats(m_positions, 3, has_bounds)},
                   {"NORMAL", document.add_floats(m_normals, 3)},
                   {"_SEGMENT", document.add_floats(
                                  std::vector<float>(m_points.size(), static_cast<float>(segment)), 1)}};
    if (m_has_texture)
      result["TEXCOORD_0"] = document.add_floats(m_textures, 2);
    if (m_has_colors)
      result["COLOR_0"] = document.add_floats(m_colors, 4);
    return result;
  }

private:
  void add_color(const std::array<unsigned char, 4>& color)
  {
    for (std::size_t part = 0; part < 3; ++part)
      m_colors.push_back(static_cast<float>(decode_sRGB(color[part])));
    m_colors.push_back(static_cast<float>(color[3] / 255.));
  }

  const Polygon_soup& m_soup;
  const Gltf_frame& m_frame;
  bool m_has_texture, m_has_colors;
  static constexpr std::uint32_t none = 0xffffffff;
  std::unordered_map<std::size_t, std::uint32_t> m_last_of_point; // the vertex that was added last
  std::vector<std::uint32_t> m_earlier; // of each vertex: the one before at its point
  std::vector<std::size_t> m_textures_of_vertices;
  std::vector<Normal> m_normals_of_vertices;
  std::vector<std::size_t> m_points;
  std::vector<float> m_positions, m_normals, m_textures, m_colors;
};

// Those of the input where it has some, made unit vectors as glTF wants them; else computed.
std::vector<std::vector<Normal>> normals_of(const Polygon_soup& soup)
{
  std::vector<std::vector<Normal>> result = corner_normals(soup);
  const Corner_values<3>& normals = soup.attributes.normals;
  for (std::size_t face = 0; face < result.size(); ++face)
    for (std::size_t i = 0; normals.has(face) && i < result[face].size(); ++i)
    {
      const std::array<double, 3>& n = normals.values[normals.indices[face][i]];
      const double length = std::hypot(n[0], n[1], n[2]);
      if (length > 0 && std::isfinite(length))
        result[face][i] = {float(n[0] / length), float(n[1] / length), float(n[2] / length)};
    }
  return result;
}

// Faces of a segment with one material of the input, or without that.
struct Group_of_faces
{
  std::size_t segment, material;
  std::vector<std::size_t> faces;
};

std::vector<Group_of_faces> groups_of_faces(const Output& output)
{
  const std::vector<std::size_t>& materials = output.surface.soup.attributes.materials;
  const bool has_materials = output.options.are_colors_of_input && !materials.empty();
  const std::vector<std::vector<std::size_t>> faces = faces_of_segments(output.surface);
  std::vector<Group_of_faces> result;
  for (std::size_t segment = 0; segment < faces.size(); ++segment)
  {
    std::map<std::size_t, std::vector<std::size_t>> of_materials;
    for (const std::size_t face : faces[segment])
      of_materials[has_materials ? materials[face] : no_index].push_back(face);
    for (auto& [material, faces_of_material] : of_materials)
      result.push_back({segment, material, std::move(faces_of_material)});
  }
  return result;
}

std::vector<std::uint32_t> corners_of_triangles(const std::vector<std::size_t>& faces,
                                                const Polygon_soup& soup,
                                                const std::vector<std::vector<Normal>>& normals,
                                                Vertices& vertices)
{
  std::vector<std::uint32_t> corners;
  for (const std::size_t face : faces)
  {
    Polygon vertex_of_corner;
    for (std::size_t i = 0; i < soup.polygons[face].size() && soup.polygons[face].size() > 2; ++i)
      vertex_of_corner.push_back(vertices.add(face, i, normals[face][i]));
    for_each_triangle(vertex_of_corner,
                      [&](auto a, auto b, auto c)
                      {
                        for (const std::size_t vertex : {a, b, c})
                          corners.push_back(static_cast<std::uint32_t>(vertex));
                      });
  }
  return corners;
}

} // namespace

Gltf_frame::Gltf_frame(const std::vector<Point>& points, const std::string& up) : m_is_turned(up == "z")
{
  // A mesh that is so many times as far from the origin as it is large loses as many of the 24 bits of its coordinates.
  constexpr double farthest = 64;
  constexpr double largest = 1e30,
                   smallest = 1e-30; // squares and products of these are no matter for single precision
  const Ball ball = bounding_ball(points);
  if (!(ball.radius < largest && ball.radius > smallest))
    m_scale = ball.radius;
  const double distance = (std::max)(
    {std::abs(ball.center[0]), std::abs(ball.center[1]), std::abs(ball.center[2])});
  if (m_scale != 1 || distance > farthest * ball.radius)
    m_center = ball.center;
}

std::array<float, 3> Gltf_frame::position(const Point& point) const
{
  std::array<float, 3> result;
  for (int c = 0; c < 3; ++c)
    result[std::size_t(c)] = static_cast<float>((point[c] - m_center[std::size_t(c)]) / m_scale);
  return result;
}

std::vector<std::size_t> Gltf_frame::add_root(const std::vector<std::size_t>& nodes,
                                              Gltf_document& document) const
{
  Json root = Json::object();
  std::array<double, 3> translation = m_center;
  if (m_is_turned)
  {
    const double half = std::sqrt(0.5);
    root["rotation"] = {-half, 0, 0, half}; // about the x-axis: from z to y
    translation = {m_center[0], m_center[2], -m_center[1]};
  }
  if (m_center != std::array<double, 3>{0, 0, 0})
    root["translation"] = translation;
  if (m_scale != 1)
    root["scale"] = {m_scale, m_scale, m_scale};
  if (root.empty())
    return nodes;
  if (nodes.size() == 1) // it is its own root
  {
    document.element("nodes", nodes.front()).update(root);
    return nodes;
  }
  root["name"] = "mesh";
  root["children"] = nodes;
  return {document.append("nodes", root)};
}

std::vector<Segment_primitive> add_primitives(const Output& output,
                                              const Gltf_frame& frame,
                                              Gltf_document& document,
                                              const Add_attributes& add_attributes)
{
  const Segmented_soup& segmented = output.surface;
  const Polygon_soup& soup = segmented.soup;
  const bool has_colors = output.options.are_colors_of_input && !soup.attributes.colors.empty();
  const std::vector<std::vector<Normal>> normals = normals_of(soup);
  Copied_materials copied(output.options.are_colors_of_input ? soup.attributes : Surface_attributes(),
                          document);
  std::vector<Segment_primitive> result;
  for (const auto& [segment, material, faces] : groups_of_faces(output))
  {
    const bool has_texture = std::any_of(faces.begin(), faces.end(),
                                         [&](std::size_t face)
                                         { return soup.attributes.texture_coordinates.has(face); });
    Vertices vertices(soup, frame, has_texture, has_colors);
    const std::vector<std::uint32_t> corners = corners_of_triangles(faces, soup, normals, vertices);
    if (corners.empty())
      continue;
    const std::string name = segmented.name_of(segment);
    Json attributes = vertices.add_attributes(segment, document);
    if (add_attributes)
      add_attributes(vertices.points(), attributes);
    const auto of_input = material == no_index ? std::nullopt : copied.material(material);
    result.push_back(
      {segment,
       name,
       {{"attributes", attributes},
        {"indices", document.add_corners(corners)},
        {"material", of_input ? *of_input : document.add_material(segment, name, has_colors)}}});
  }
  return result;
}

} // namespace tool
