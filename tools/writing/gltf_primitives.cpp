// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/gltf_primitives.h"

#include "writing/corner_normals.h"
#include "writing/triangles.h"
#include "writing/unit_ball.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace tool {
namespace {

using Json = Gltf_document::Json;

// What a mesh in glTF has for each vertex: points are there once for each of their normals.
class Vertices
{
public:
  explicit Vertices(const Gltf_frame& frame) : m_frame(frame) {}

  std::uint32_t add(std::size_t index, const Point& point, const Normal& normal)
  {
    const auto next = static_cast<std::uint32_t>(m_indices.size());
    const auto [position, is_new] = m_indices.emplace(std::make_tuple(index, normal), next);
    if (is_new)
    {
      const std::array<float, 3> coordinates = m_frame.position(point);
      m_positions.insert(m_positions.end(), coordinates.begin(), coordinates.end());
      m_normals.insert(m_normals.end(), normal.begin(), normal.end());
    }
    return position->second;
  }

  std::size_t size() const { return m_indices.size(); }

  Json add_attributes(std::size_t segment, Gltf_document& document) const
  {
    constexpr bool has_bounds = true;
    return {
      {"POSITION", document.add_floats(m_positions, 3, has_bounds)},
      {"NORMAL", document.add_floats(m_normals, 3)},
      {"_SEGMENT", document.add_floats(std::vector<float>(size(), static_cast<float>(segment)), 1)}};
  }

private:
  const Gltf_frame& m_frame;
  std::map<std::tuple<std::size_t, Normal>, std::uint32_t> m_indices;
  std::vector<float> m_positions, m_normals;
};

} // namespace

Gltf_frame::Gltf_frame(const std::vector<Point>& points, const std::string& up) : m_is_turned(up == "z")
{
  // A mesh that is so many times as far from the origin as it is large loses as many of the 24 bits of its coordinates.
  constexpr double far = 64;
  constexpr double largest = 1e30,
                   smallest = 1e-30; // squares and products of these are no matter for single precision
  const Ball ball = bounding_ball(points);
  if (!(ball.radius < largest && ball.radius > smallest))
    m_scale = ball.radius;
  const double distance = (std::max)(
    {std::abs(ball.center[0]), std::abs(ball.center[1]), std::abs(ball.center[2])});
  if (m_scale != 1 || distance > far * ball.radius)
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

std::vector<Segment_primitive> add_primitives(const Segmented_soup& segmented,
                                              const Gltf_frame& frame,
                                              Gltf_document& document,
                                              const Add_attributes& add_attributes)
{
  const std::vector<std::vector<Normal>> normals = corner_normals(segmented.soup);
  const std::vector<std::vector<std::size_t>> faces = faces_of_segments(segmented);
  std::vector<Segment_primitive> result;
  for (std::size_t segment = 0; segment < faces.size(); ++segment)
  {
    Vertices vertices(frame);
    std::vector<std::uint32_t> corners;
    for (const std::size_t face : faces[segment])
    {
      const Polygon& polygon = segmented.soup.polygons[face];
      Polygon vertex_of_corner;
      for (std::size_t i = 0; i < polygon.size() && polygon.size() > 2; ++i)
        vertex_of_corner.push_back(
          vertices.add(polygon[i], segmented.soup.points[polygon[i]], normals[face][i]));
      for_each_triangle(vertex_of_corner,
                        [&](auto a, auto b, auto c)
                        {
                          for (const std::size_t vertex : {a, b, c})
                            corners.push_back(static_cast<std::uint32_t>(vertex));
                        });
    }
    if (corners.empty())
      continue;
    const std::string name = segmented.name_of(segment);
    Json attributes = vertices.add_attributes(segment, document);
    if (add_attributes)
      add_attributes(segment, vertices.size(), attributes);
    result.push_back({segment,
                      name,
                      {{"attributes", attributes},
                       {"indices", document.add_corners(corners)},
                       {"material", document.add_material(segment, name)}}});
  }
  return result;
}

} // namespace tool
