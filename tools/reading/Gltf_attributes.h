// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_GLTF_ATTRIBUTES_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_GLTF_ATTRIBUTES_H

#include "reading/Gltf_accessors.h"
#include "reading/Polygon_soup.h"
#include "writing/palette.h"

#include <CGAL/Aff_transformation_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace tool {

// Normals, texture coordinates and colours of the vertices of a glTF file. Those that cannot be read are left out.
class Gltf_attributes
{
public:
  using Transformation = CGAL::Aff_transformation_3<CGAL::Simple_cartesian<double>>;

  explicit Gltf_attributes(const Gltf_accessors& accessors) : m_accessors(accessors) {}

  // Of the next so many vertices.
  void add(const tinygltf::Primitive& primitive,
           std::size_t number_of_vertices,
           const Transformation& transform)
  {
    const std::vector<double> textures = numbers(primitive, "TEXCOORD_0", 2, number_of_vertices);
    const std::vector<double> normals = numbers(primitive, "NORMAL", 3, number_of_vertices);
    std::size_t parts = 4;
    std::vector<double> colors = numbers(primitive, "COLOR_0", 4, number_of_vertices);
    if (colors.empty())
      colors = numbers(primitive, "COLOR_0", int(parts = 3), number_of_vertices);
    for (std::size_t i = 0; i < number_of_vertices; ++i)
    {
      m_has_texture.push_back(!textures.empty());
      m_textures.push_back({0, 0});
      if (!textures.empty())
        m_textures.back() = {textures[2 * i], 1 - textures[2 * i + 1]}; // glTF counts downwards
      m_has_normal.push_back(!normals.empty());
      m_normals.push_back({0, 0, 0});
      if (!normals.empty())
        m_normals.back() = turned({normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]}, transform);
      m_are_all_colored = m_are_all_colored && !colors.empty();
      if (!m_are_all_colored)
        continue;
      m_colors.push_back({0, 0, 0, 255});
      for (std::size_t part = 0; part < 3; ++part)
        m_colors.back()[part] = encode_sRGB(colors[parts * i + part]); // linear in glTF
      if (parts == 4)
        m_colors.back()[3] = static_cast<unsigned char>(
          std::lround(255 * std::clamp(colors[4 * i + 3], 0., 1.)));
    }
  }

  Surface_attributes take(const Polygons& polygons)
  {
    Surface_attributes result;
    spread(m_textures, m_has_texture, polygons, result.texture_coordinates);
    spread(m_normals, m_has_normal, polygons, result.normals);
    if (m_are_all_colored)
      result.colors = std::move(m_colors);
    return result;
  }

private:
  // None if there are not as many as vertices.
  std::vector<double> numbers(const tinygltf::Primitive& primitive,
                              const std::string& name,
                              int dimension,
                              std::size_t number_of_vertices) const
  {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end())
      return {};
    try
    {
      std::vector<double> result = m_accessors.numbers(found->second, dimension);
      return result.size() == number_of_vertices * std::size_t(dimension) ? result
                                                                          : std::vector<double>();
    }
    catch (const Format_error&)
    {
      return {};
    }
  }

  // By the cofactors of the matrix, which keep normals normal to the surface.
  static std::array<double, 3> turned(const std::array<double, 3>& normal,
                                      const Transformation& transform)
  {
    const auto cofactor = [&](int i, int j)
    {
      const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      return transform.m(a, c) * transform.m(b, d) - transform.m(a, d) * transform.m(b, c);
    };
    std::array<double, 3> result = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        result[std::size_t(i)] += cofactor(i, j) * normal[std::size_t(j)];
    const double length = std::hypot(result[0], result[1], result[2]) * (transform.is_odd() ? -1 : 1);
    for (double& coordinate : result)
      coordinate /= length != 0 ? length : 1;
    return result;
  }

  template <std::size_t dimension>
  static void spread(std::vector<std::array<double, dimension>>& values,
                     const std::vector<bool>& is_known,
                     const Polygons& polygons,
                     Corner_values<dimension>& corners)
  {
    if (std::find(is_known.begin(), is_known.end(), true) == is_known.end())
      return;
    corners.values = std::move(values);
    corners.indices = vectors_of(polygons);
    for (Polygon& face : corners.indices)
      for (std::size_t& index : face)
        if (!is_known[index])
          index = no_index;
  }

  const Gltf_accessors& m_accessors;
  std::vector<std::array<double, 2>> m_textures;
  std::vector<std::array<double, 3>> m_normals;
  std::vector<bool> m_has_texture, m_has_normal;
  std::vector<std::array<unsigned char, 4>> m_colors;
  bool m_are_all_colored = true;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_GLTF_ATTRIBUTES_H
