// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_OBJ_ATTRIBUTES_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_OBJ_ATTRIBUTES_H

#include "command_line/number.h"
#include "reading/Lines.h"
#include "reading/Surface_attributes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tool {

// Texture coordinates, normals, colours and materials of an OBJ file. None of them keeps a file from being read: what makes no
// sense is left out.
class OBJ_attributes
{
public:
  // A line of the file, by its first word; lines of faces have the corners as they are.
  void add(std::string_view keyword, std::string_view words)
  {
    if (keyword == "v")
      add_color(words);
    else if (keyword == "vt")
      add_value(words, m_attributes.texture_coordinates);
    else if (keyword == "vn")
      add_value(words, m_attributes.normals);
    else if (keyword == "f" || keyword == "fo")
      add_face(words);
    else if (keyword == "usemtl")
      use(std::string(trim(words)));
    else if (keyword == "mtllib")
      m_attributes.material_files.emplace_back(trim(words));
  }

  Surface_attributes take(std::size_t number_of_points)
  {
    if (!m_are_all_colored || m_attributes.colors.size() != number_of_points)
      m_attributes.colors.clear();
    const std::size_t number_of_faces = m_attributes.materials.size();
    if (m_attributes.material_names.empty())
      m_attributes.materials.clear();
    clear_if_unused(m_attributes.texture_coordinates, number_of_faces);
    clear_if_unused(m_attributes.normals, number_of_faces);
    return std::move(m_attributes);
  }

private:
  // Three coordinates and three parts of a colour from 0 to 1.
  void add_color(std::string_view words)
  {
    std::vector<double> numbers;
    for (std::string_view word = take_word(words); !word.empty() && m_are_all_colored;
         word = take_word(words))
      numbers.push_back(number<double>(word).value_or(-1));
    m_are_all_colored = m_are_all_colored && numbers.size() == 6 &&
                        std::all_of(numbers.begin() + 3, numbers.end(),
                                    [](double part) { return part >= 0 && part <= 1; });
    if (!m_are_all_colored)
      return;
    const auto byte = [](double part) { return static_cast<unsigned char>(std::lround(255 * part)); };
    m_attributes.colors.push_back({byte(numbers[3]), byte(numbers[4]), byte(numbers[5]), 255});
  }

  template <std::size_t dimension>
  static void add_value(std::string_view words, Corner_values<dimension>& corners)
  {
    std::array<double, dimension> value;
    for (double& coordinate : value)
      coordinate = number<double>(take_word(words)).value_or(0);
    corners.values.push_back(value);
  }

  void use(const std::string& name)
  {
    const auto [known, is_new] = m_materials.emplace(name, m_attributes.material_names.size());
    if (is_new)
      m_attributes.material_names.push_back(name);
    m_material = known->second;
  }

  void add_face(std::string_view words)
  {
    m_attributes.materials.push_back(m_material);
    if (words.find('/') == words.npos) // of vertices alone
      return;
    const std::size_t number_of_earlier_faces = m_attributes.materials.size() - 1;
    m_attributes.texture_coordinates.indices.resize(number_of_earlier_faces);
    m_attributes.normals.indices.resize(number_of_earlier_faces);
    std::vector<std::size_t> textures, normals;
    for (std::string_view corner = take_word(words); !corner.empty(); corner = take_word(words))
    {
      const std::size_t first = (std::min)(corner.find('/'), corner.size());
      const std::size_t second = (std::min)(corner.find('/', first + 1), corner.size());
      textures.push_back(index(corner.substr((std::min)(first + 1, corner.size()), second - first - 1),
                               m_attributes.texture_coordinates.values.size()));
      normals.push_back(
        index(corner.substr((std::min)(second + 1, corner.size())), m_attributes.normals.values.size()));
    }
    m_attributes.texture_coordinates.indices.push_back(known(std::move(textures)));
    m_attributes.normals.indices.push_back(known(std::move(normals)));
  }

  // From 1, or from the last one by negative numbers. It may be that of a value that comes later.
  static std::size_t index(std::string_view word, std::size_t size)
  {
    const auto index = number<long>(word);
    if (!index || *index == 0 || (*index < 0 && std::size_t(-*index) > size))
      return no_index;
    return *index > 0 ? std::size_t(*index) - 1 : size - std::size_t(-*index);
  }

  static std::vector<std::size_t> known(std::vector<std::size_t> indices)
  {
    const bool is_none = std::all_of(indices.begin(), indices.end(),
                                     [](std::size_t i) { return i == no_index; });
    return is_none ? std::vector<std::size_t>() : std::move(indices);
  }

  template <std::size_t dimension>
  static void clear_if_unused(Corner_values<dimension>& corners, std::size_t number_of_faces)
  {
    corners.indices.resize(number_of_faces);
    bool is_used = false;
    for (std::vector<std::size_t>& face : corners.indices)
      for (std::size_t& index : face)
      {
        if (index >= corners.values.size())
          index = no_index;
        is_used = is_used || index != no_index;
      }
    if (!is_used)
      corners = {};
  }

  Surface_attributes m_attributes;
  bool m_are_all_colored = true;
  std::map<std::string, std::size_t> m_materials;
  std::size_t m_material = no_index;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_OBJ_ATTRIBUTES_H
