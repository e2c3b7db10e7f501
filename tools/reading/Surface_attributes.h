// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_SURFACE_ATTRIBUTES_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_SURFACE_ATTRIBUTES_H

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace tool
{

constexpr std::size_t no_index = (std::numeric_limits<std::size_t>::max)();

// Vectors at the corners of faces. Corners may share them, and two faces may have different ones at one point, as at the seams
// of a texture.
template <std::size_t dimension>
struct Corner_values
{
  std::vector<std::array<double, dimension>> values;
  std::vector<std::vector<std::size_t>> indices; // of each face, for each corner a value or `no_index`; or none at all

  bool is_empty() const { return values.empty(); }

  // Do all corners of the face have values?
  bool has(std::size_t face) const
  {
    if (is_empty() || indices[face].empty())
      return false;
    for (const std::size_t index : indices[face])
      if (index == no_index)
        return false;
    return true;
  }
};

// A picture of a glTF file: what is in it or, if that was not found, where it should be.
struct Picture
{
  std::string bytes, mime_type, uri;
};

// The materials of a glTF file: its JSON, and its pictures in their order.
struct Gltf_materials
{
  std::string json;
  std::vector<Picture> pictures;
};

// What a file says of a surface besides points and faces. What it does not say is empty.
struct Surface_attributes
{
  Corner_values<2> texture_coordinates;
  Corner_values<3> normals;
  std::vector<std::array<unsigned char, 4>> colors; // of the points: red, green, blue, alpha
  std::vector<std::size_t> materials;               // of the faces, by their names, or `no_index`
  std::vector<std::string> material_names;
  std::vector<std::string> material_files; // those of OBJ
  std::shared_ptr<const Gltf_materials> gltf_materials; // of a glTF file, whose numbers those of the faces are
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_SURFACE_ATTRIBUTES_H
