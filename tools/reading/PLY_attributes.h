// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_PLY_ATTRIBUTES_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_PLY_ATTRIBUTES_H

#include "reading/PLY_header.h"
#include "reading/Polygon_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tool {
namespace PLY {

// Colours, normals and texture coordinates of the vertices of a PLY file.
class Attributes
{
public:
  explicit Attributes(const Element& vertex)
  {
    for (std::size_t i = 0; i < vertex.properties.size(); ++i)
      if (!vertex.properties[i].count_type)
        find_place(vertex.properties[i].name, i, vertex.properties[i].type.kind == 'f');
  }

  // `values` are those of the properties of the next vertex.
  void add_vertex(const std::vector<double>& values)
  {
    if (has(m_color_places, 3))
      m_attributes.colors.push_back(color(values));
    add(values, m_normal_places, m_attributes.normals);
    add(values, m_texture_places, m_attributes.texture_coordinates);
  }

  // The values of vertices become those of the corners. Only if there is one for each: a file may have vertices twice.
  Surface_attributes take(const Polygon_soup& soup)
  {
    spread(m_attributes.normals, soup);
    spread(m_attributes.texture_coordinates, soup);
    if (m_attributes.colors.size() != soup.points.size())
      m_attributes.colors.clear();
    return std::move(m_attributes);
  }

private:
  void find_place(const std::string& name, std::size_t place, bool is_real)
  {
    const auto find = [&](const std::vector<std::string>& names, auto& places)
    {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end())
        return false;
      places[std::size_t(found - names.begin()) % places.size()] = place;
      return true;
    };
    find({"nx", "ny", "nz"}, m_normal_places);
    find({"s", "t", "u", "v", "texture_u", "texture_v"}, m_texture_places);
    if (find({"red", "green", "blue", "alpha"}, m_color_places))
      m_largest_color = is_real ? 1 : 255;
  }

  template <std::size_t size>
  static bool has(const std::array<std::size_t, size>& places, std::size_t needed)
  {
    return std::none_of(places.begin(), places.begin() + std::ptrdiff_t(needed),
                        [](std::size_t place) { return place == no_index; });
  }

  std::array<unsigned char, 4> color(const std::vector<double>& values) const
  {
    std::array<unsigned char, 4> result;
    for (std::size_t i = 0; i < result.size(); ++i)
    {
      const double part = m_color_places[i] == no_index ? 1 : values[m_color_places[i]] / m_largest_color;
      result[i] = static_cast<unsigned char>(std::lround(255 * (part >= 0 ? (std::min)(part, 1.) : 0)));
    }
    return result;
  }

  template <std::size_t size>
  static void add(const std::vector<double>& values,
                  const std::array<std::size_t, size>& places,
                  Corner_values<size>& corners)
  {
    if (!has(places, size))
      return;
    corners.values.emplace_back();
    for (std::size_t i = 0; i < size; ++i)
      corners.values.back()[i] = values[places[i]];
  }

  template <std::size_t size>
  static void spread(Corner_values<size>& corners, const Polygon_soup& soup)
  {
    if (corners.values.size() == soup.points.size())
      corners.indices = vectors_of(soup.polygons);
    else
      corners = {};
  }

  Surface_attributes m_attributes;
  std::array<std::size_t, 3> m_normal_places = {no_index, no_index, no_index};
  std::array<std::size_t, 2> m_texture_places = {no_index, no_index};
  std::array<std::size_t, 4> m_color_places = {no_index, no_index, no_index, no_index};
  double m_largest_color = 255;
};

} // namespace PLY
} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_PLY_ATTRIBUTES_H
