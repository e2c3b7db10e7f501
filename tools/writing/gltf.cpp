// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/formats.h"

#include "writing/Gltf_document.h"
#include "writing/gltf_primitives.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tool {
namespace {

using Json = Gltf_document::Json;

std::size_t add_mesh(const std::string& name, const Json& primitives, Gltf_document& document)
{
  return document.append("meshes", {{"name", name}, {"primitives", primitives}});
}

std::vector<std::size_t> add_node_of_all(const std::vector<Segment_primitive>& primitives,
                                         Gltf_document& document)
{
  Json all = Json::array();
  for (const auto& [segment, name, primitive] : primitives)
    all.push_back(primitive);
  return {document.append("nodes", {{"name", "mesh"}, {"mesh", add_mesh("mesh", all, document)}})};
}

// Those of one segment follow each other.
std::vector<std::size_t> add_node_for_each_segment(const std::vector<Segment_primitive>& primitives,
                                                   Gltf_document& document)
{
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < primitives.size();)
  {
    const auto& [segment, name, first] = primitives[i];
    Json of_segment = Json::array();
    for (; i < primitives.size() && primitives[i].segment == segment; ++i)
      of_segment.push_back(primitives[i].primitive);
    nodes.push_back(document.append("nodes", {{"name", name},
                                              {"mesh", add_mesh(name, of_segment, document)},
                                              {"extras", {{"segment", segment}}}}));
  }
  return nodes;
}

Gltf_document make_document(const Output& output)
{
  Gltf_document document;
  const Gltf_frame frame(output.surface.soup.points, output.options.up);
  const std::vector<Segment_primitive> primitives = add_primitives(output, frame, document);
  document.set_roots(frame.add_root(output.options.is_one_object
                                      ? add_node_of_all(primitives, document)
                                      : add_node_for_each_segment(primitives, document),
                                    document));
  return document;
}

} // namespace

void write_GLB(std::ostream& out, const Output& output)
{
  make_document(output).write_binary(out);
}

void write_GLTF(std::ostream& out, const Output& output)
{
  make_document(output).write_text(out);
}

} // namespace tool
