// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_GLTF_MATERIALS_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_GLTF_MATERIALS_H

#include "reading/Surface_attributes.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// For tinygltf: keeps the bytes of a picture as they are in its file. Those in buffers are taken from there later, for tinygltf
// does not check that they are there.
inline bool keep_picture(tinygltf::Image* image,
                         int,
                         std::string*,
                         std::string*,
                         int,
                         int,
                         const unsigned char* bytes,
                         int size,
                         void*)
{
  if (image->bufferView < 0)
    image->image.assign(bytes, bytes + size);
  return true;
}

// The JSON of a file, without its buffer.
inline std::string json_of_glTF(const std::string& bytes)
{
  constexpr std::size_t begin = 20,
                        place_of_length = 12; // behind the headers of the file and of the first chunk
  if (bytes.compare(0, 4, "glTF") != 0)
    return bytes;
  std::uint32_t length = 0;
  if (bytes.size() < begin)
    return "";
  std::memcpy(&length, bytes.data() + place_of_length, sizeof(length));
  return bytes.substr(begin, length);
}

inline Picture picture_of(const tinygltf::Image& image, const tinygltf::Model& model)
{
  Picture picture = {std::string(image.image.begin(), image.image.end()), image.mimeType, image.uri};
  if (image.bufferView < 0 || std::size_t(image.bufferView) >= model.bufferViews.size())
    return picture;
  const tinygltf::BufferView& view = model.bufferViews[std::size_t(image.bufferView)];
  if (view.buffer < 0 || std::size_t(view.buffer) >= model.buffers.size())
    return picture;
  const std::vector<unsigned char>& data = model.buffers[std::size_t(view.buffer)].data;
  if (view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset)
    picture.bytes.assign(reinterpret_cast<const char*>(data.data()) + view.byteOffset, view.byteLength);
  return picture;
}

// `materials` are those of the faces, as their numbers in the file, or `no_index`.
inline void add_materials(const tinygltf::Model& model,
                          const std::string& bytes,
                          std::vector<std::size_t> materials,
                          Surface_attributes& attributes)
{
  const auto is_none = [](std::size_t material) { return material == no_index; };
  if (std::all_of(materials.begin(), materials.end(), is_none))
    return;
  attributes.materials = std::move(materials);
  for (std::size_t i = 0; i < model.materials.size(); ++i)
  {
    std::string name = model.materials[i].name.empty() ? "material_" + std::to_string(i)
                                                       : model.materials[i].name;
    std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isspace(c) != 0; }, '_');
    attributes.material_names.push_back(name);
  }
  Gltf_materials kept = {json_of_glTF(bytes), {}};
  for (const tinygltf::Image& image : model.images)
    kept.pictures.push_back(picture_of(image, model));
  attributes.gltf_materials = std::make_shared<const Gltf_materials>(std::move(kept));
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_GLTF_MATERIALS_H
