// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_COPIED_MATERIALS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_COPIED_MATERIALS_H

#include "reading/Surface_attributes.h"
#include "writing/Gltf_document.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace tool {

// The materials of the input in a glTF file that is being made, with the textures that these need.
class Copied_materials
{
public:
  // Those of a glTF file, or of the material files of OBJ.
  Copied_materials(const Surface_attributes& attributes, Gltf_document& document);

  // The number in the document of one of the input; none if there is no such material.
  std::optional<std::size_t> material(std::size_t number);

private:
  using Json = Gltf_document::Json;
  using Numbers = std::map<std::size_t, std::optional<std::size_t>>;

  Json copied(const Json& element);
  std::optional<std::size_t> texture(std::size_t number);
  std::optional<std::size_t> sampler(std::size_t number);
  std::optional<std::size_t> image(std::size_t number);
  std::optional<Json> element(const char* list, std::size_t number) const;
  void note_extensions(const Json& extensions);

  std::shared_ptr<const Gltf_materials> m_input;
  Json m_json;
  Gltf_document& m_document;
  Numbers m_materials, m_textures, m_samplers, m_images; // in the document
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_COPIED_MATERIALS_H
