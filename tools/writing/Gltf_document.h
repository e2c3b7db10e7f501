// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_GLTF_DOCUMENT_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_GLTF_DOCUMENT_H

#include "writing/Segmented_soup.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

// A glTF 2.0 file that is being made: its JSON and its buffer.
class Gltf_document
{
public:
  using Json = nlohmann::ordered_json;

  Gltf_document();

  // Returns the index of the element in the list, which is made if needed.
  std::size_t append(const char* list, const Json& element);

  Json& element(const char* list, std::size_t index) { return m_json[list][index]; }

  // Accessors of attributes of vertices: of vectors of so many numbers, or of one number each. With the bounds that
  // positions and times must have.
  std::size_t add_floats(const std::vector<float>& numbers,
                         std::size_t dimension,
                         bool has_bounds = false);
  std::size_t add_joints(const std::vector<std::uint16_t>& joints); // four for each vertex
  std::size_t add_matrices(const std::vector<float>& numbers);
  std::size_t add_corners(const std::vector<std::uint32_t>& corners);

  // White if vertices have the colours.
  std::size_t add_material(std::size_t segment, const std::string& name, bool is_white = false);

  // A picture as it is in its file. Returns its index among the images.
  std::size_t add_picture(const std::string& bytes, const std::string& mime_type);

  // Says that elements use an extension, and whether the file cannot be shown without it.
  void use_extension(const std::string& name, bool is_required);

  void set_roots(const std::vector<std::size_t>& nodes) { m_json["scenes"][0]["nodes"] = nodes; }

  void write_binary(std::ostream& out) const;
  void write_text(std::ostream& out) const;

private:
  template <typename T>
  std::size_t add_view(const std::vector<T>& numbers, int target);
  std::string text_with_buffer(const Json& buffer, int indentation) const;

  Json m_json;
  std::string m_bytes;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_GLTF_DOCUMENT_H
