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

// One node with a mesh of all primitives, or a node with a mesh for each.
std::vector<std::size_t> add_nodes(const std::vector<Segment_primitive>& primitives,
                                   bool is_one_object,
                                   Gltf_document& document)
{
  std::vector<std::size_t> nodes;
  Json all = Json::array();
  for (const auto& [segment, name, primitive] : primitives)
    if (is_one_object)
      all.push_back(primitive);
    else
    {
      const std::size_t mesh = document.append(
        "meshes", {{"name", name}, {"primitives", Json::array({primitive})}});
      nodes.push_back(
        document.append("nodes", {{"name", name}, {"mesh", mesh}, {"extras", {{"segment", segment}}}}));
    }
  if (is_one_object)
    nodes.push_back(document.append(
      "nodes",
      {{"name", "mesh"}, {"mesh", document.append("meshes", {{"name", "mesh"}, {"primitives", all}})}}));
  return nodes;
}

Gltf_document make_document(const Output& output)
{
  Gltf_document document;
  const Gltf_frame frame(output.surface.soup.points, output.options.up);
  document.set_roots(frame.add_root(
    add_nodes(add_primitives(output, frame, document), output.options.is_one_object, document),
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
