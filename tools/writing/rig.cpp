// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/skeleton.h"

#include "writing/Gltf_document.h"
#include "writing/gltf_primitives.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tool {
namespace {

// The joints that move segments, and those that move points.
class Moving_joints
{
public:
  Moving_joints(const Segmented_soup& segmented, const std::vector<Joint>& joints)
  {
    std::vector<std::size_t> depths;
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
      depths.push_back(joints[i].parent == i ? 0 : depths[joints[i].parent] + 1);
      if (!joints[i].is_tip)
        m_of_segment.emplace(joints[i].segment, i);
    }
    const Polygon_soup& soup = segmented.soup;
    for (std::size_t face = 0; face < soup.polygons.size(); ++face)
      for (const std::size_t corner : soup.polygons[face])
      {
        const std::size_t joint = m_of_segment.at(segmented.segments[face]);
        const auto [known, is_new] = m_of_point.emplace(soup.points[corner], joint);
        if (!is_new && depths[joint] < depths[known->second])
          known->second = joint;
      }
  }

  std::size_t of_point(const Point& point) const { return m_of_point.at(point); }

private:
  std::map<std::size_t, std::size_t> m_of_segment;
  std::map<Point, std::size_t> m_of_point; // by its place: a file may have a point more than once
};

// A node for each joint, with those that hang on it. Returns the first one's number.
std::size_t add_joints(const std::vector<Joint>& joints,
                       const Segmented_soup& segmented,
                       const Gltf_frame& frame,
                       Gltf_document& document)
{
  std::size_t first = 0;
  for (std::size_t i = 0; i < joints.size(); ++i)
  {
    const std::array<float, 3> place = frame.position(joints[i].point);
    std::array<float, 3> translation = place;
    if (joints[i].parent != i)
    {
      const std::array<float, 3> of_parent = frame.position(joints[joints[i].parent].point);
      for (std::size_t c = 0; c < 3; ++c)
        translation[c] -= of_parent[c];
    }
    const std::string name = segmented.name_of(joints[i].segment) + (joints[i].is_tip ? " end" : "");
    const std::size_t node = document.append("nodes", {{"name", name}, {"translation", translation}});
    if (i == 0)
      first = node;
    if (joints[i].parent != i)
      document.element("nodes", first + joints[i].parent)["children"].push_back(node);
  }
  return first;
}

std::size_t add_skin(const std::vector<Joint>& joints,
                     const Gltf_frame& frame,
                     std::size_t first_node,
                     std::size_t armature,
                     Gltf_document& document)
{
  std::vector<std::size_t> nodes;
  std::vector<float> matrices; // by columns; each moves its joint to the origin
  for (std::size_t i = 0; i < joints.size(); ++i)
  {
    nodes.push_back(first_node + i);
    const std::array<float, 3> place = frame.position(joints[i].point);
    matrices.insert(matrices.end(),
                    {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -place[0], -place[1], -place[2], 1});
  }
  return document.append("skins", {{"joints", nodes},
                                   {"skeleton", armature},
                                   {"inverseBindMatrices", document.add_matrices(matrices)}});
}

Gltf_document make_rig(const Output& output, const std::vector<Joint>& joints)
{
  constexpr std::size_t joints_of_vertex = 4; // of which one moves it
  Gltf_document document;
  const Segmented_soup& segmented = output.surface;
  const Gltf_frame frame(segmented.soup.points, output.options.up);
  const Moving_joints moving_joints(segmented, joints);
  const auto add_weights = [&](const std::vector<std::size_t>& points, Gltf_document::Json& attributes)
  {
    std::vector<std::uint16_t> of_vertices(joints_of_vertex * points.size(), 0);
    std::vector<float> weights(of_vertices.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      of_vertices[joints_of_vertex * i] = static_cast<std::uint16_t>(
        moving_joints.of_point(segmented.soup.points[points[i]]));
      weights[joints_of_vertex * i] = 1;
    }
    attributes["JOINTS_0"] = document.add_joints(of_vertices);
    attributes["WEIGHTS_0"] = document.add_floats(weights, joints_of_vertex);
  };
  Gltf_document::Json primitives = Gltf_document::Json::array();
  for (const Segment_primitive& primitive : add_primitives(output, frame, document, add_weights))
    primitives.push_back(primitive.primitive);
  const std::size_t first = add_joints(joints, segmented, frame, document);
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].parent == i)
      roots.push_back(first + i);
  const std::size_t armature = document.append("nodes", {{"name", "armature"}, {"children", roots}});
  const std::size_t mesh = document.append("meshes", {{"name", "mesh"}, {"primitives", primitives}});
  const std::size_t skin = add_skin(joints, frame, first, armature, document);
  const std::size_t node = document.append("nodes", {{"name", "mesh"}, {"mesh", mesh}, {"skin", skin}});
  std::vector<std::size_t> nodes = frame.add_root({armature}, document);
  nodes.push_back(node);
  document.set_roots(nodes);
  return document;
}

} // namespace

void write_rig(std::ostream& out, const Output& output, const std::vector<Joint>& joints, bool is_binary)
{
  const Gltf_document document = make_rig(output, joints);
  if (is_binary)
    document.write_binary(out);
  else
    document.write_text(out);
}

} // namespace tool
