// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/carried_attributes.h"

#include "writing/triangles.h"

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace tool {
namespace {

template <std::size_t dimension>
Corner_values<dimension> values_of_part(const Corner_values<dimension>& whole,
                                        const std::vector<std::size_t>& faces)
{
  Corner_values<dimension> part;
  if (whole.is_empty())
    return part;
  std::map<std::size_t, std::size_t> new_indices;
  for (const std::size_t face : faces)
  {
    part.indices.push_back(whole.indices[face]);
    for (std::size_t& index : part.indices.back())
      if (index != no_index)
      {
        const auto [position, is_new] = new_indices.emplace(index, part.values.size());
        if (is_new)
          part.values.push_back(whole.values[index]);
        index = position->second;
      }
  }
  return part;
}

template <std::size_t dimension>
Corner_values<dimension> values_of_triangles(const Corner_values<dimension>& whole,
                                             const Polygons& polygons)
{
  Corner_values<dimension> result;
  if (whole.is_empty())
    return result;
  result.values = whole.values;
  for (std::size_t face = 0; face < polygons.size(); ++face)
  {
    const bool is_known = !whole.indices[face].empty();
    if (is_known)
      for_each_triangle(whole.indices[face], [&](auto a, auto b, auto c) { result.indices.push_back({a, b, c}); });
    else
      for_each_triangle(polygons[face], [&](auto, auto, auto) { result.indices.emplace_back(); });
  }
  return result;
}

// How much of each corner of the polygon is in a point of it: the shares in the triangle of its fan that has the point, or that is
// the nearest.
std::vector<double> shares_of_corners(const std::vector<Point>& points,
                                      const Corners& polygon,
                                      const Point& point)
{
  std::vector<double> best(polygon.size(), 1. / double(polygon.size()));
  double best_least = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    const auto u = points[polygon[i - 1]] - points[polygon[0]],
               v = points[polygon[i]] - points[polygon[0]], w = point - points[polygon[0]];
    const auto normal = CGAL::cross_product(u, v);
    const double area = normal.squared_length();
    const double b = CGAL::cross_product(w, v) * normal / area,
                 c = CGAL::cross_product(u, w) * normal / area;
    const double least = (std::min)({1 - b - c, b, c});
    if (!(least > best_least)) // also if it is no number
      continue;
    best_least = least;
    std::fill(best.begin(), best.end(), 0.);
    best[0] = 1 - b - c;
    best[i - 1] = b;
    best[i] = c;
  }
  return best;
}

class Pieces
{
public:
  Pieces(const Polygon_soup& whole, const Polygon_soup& pieces, const std::vector<std::size_t>& old_faces)
    : m_whole(whole),
      m_pieces(pieces),
      m_old_faces(old_faces)
  {}

  template <std::size_t dimension>
  Corner_values<dimension> values(const Corner_values<dimension>& old) const
  {
    Corner_values<dimension> result;
    if (old.is_empty())
      return result;
    result.values = old.values;
    for (std::size_t piece = 0; piece < m_old_faces.size(); ++piece)
    {
      const std::size_t face = m_old_faces[piece];
      result.indices.emplace_back();
      if (old.has(face))
        for (const std::size_t corner : m_pieces.polygons[piece])
          result.indices.back().push_back(
            index(old.indices[face], face, m_pieces.points[corner], result.values));
    }
    result.indices.resize(m_pieces.polygons.size()); // none for what is no piece
    return result;
  }

  // A point has those of all faces that it is in.
  std::vector<std::array<unsigned char, 4>> colors() const
  {
    const auto& old = m_whole.attributes.colors;
    std::vector<std::array<unsigned char, 4>> result(old.empty() ? 0 : m_pieces.points.size(),
                                                     {255, 255, 255, 255});
    for (std::size_t piece = 0; piece < m_old_faces.size() && !old.empty(); ++piece)
      for (const std::size_t corner : m_pieces.polygons[piece])
      {
        const Corners polygon = m_whole.polygons[m_old_faces[piece]];
        const std::vector<double> shares = shares_of_corners(m_whole.points, polygon,
                                                             m_pieces.points[corner]);
        for (std::size_t part = 0; part < 4; ++part)
        {
          double sum = 0;
          for (std::size_t i = 0; i < polygon.size(); ++i)
            sum += shares[i] * old[polygon[i]][part];
          result[corner][part] = static_cast<unsigned char>(std::lround(std::clamp(sum, 0., 255.)));
        }
      }
    return result;
  }

private:
  // Of the corner's own value, or of a new one.
  template <std::size_t dimension>
  std::size_t index(const std::vector<std::size_t>& of_corners,
                    std::size_t face,
                    const Point& point,
                    std::vector<std::array<double, dimension>>& values) const
  {
    const Corners polygon = m_whole.polygons[face];
    for (std::size_t i = 0; i < polygon.size(); ++i)
      if (m_whole.points[polygon[i]] == point)
        return of_corners[i];
    const std::vector<double> shares = shares_of_corners(m_whole.points, polygon, point);
    std::array<double, dimension> value = {};
    for (std::size_t i = 0; i < polygon.size(); ++i)
      for (std::size_t c = 0; c < dimension; ++c)
        value[c] += shares[i] * values[of_corners[i]][c];
    values.push_back(value);
    return values.size() - 1;
  }

  const Polygon_soup& m_whole;
  const Polygon_soup& m_pieces;
  const std::vector<std::size_t>& m_old_faces;
};

} // namespace

Surface_attributes attributes_of_part(const Surface_attributes& whole,
                                      const std::vector<std::size_t>& faces,
                                      const std::vector<std::size_t>& points)
{
  Surface_attributes part;
  part.texture_coordinates = values_of_part(whole.texture_coordinates, faces);
  part.normals = values_of_part(whole.normals, faces);
  if (!whole.colors.empty())
    for (const std::size_t point : points)
      part.colors.push_back(whole.colors[point]);
  if (!whole.materials.empty())
    for (const std::size_t face : faces)
      part.materials.push_back(whole.materials[face]);
  part.material_names = whole.material_names;
  part.material_files = whole.material_files;
  part.gltf_materials = whole.gltf_materials;
  return part;
}

Surface_attributes attributes_of_triangles(const Polygon_soup& whole)
{
  Surface_attributes result = whole.attributes;
  result.texture_coordinates = values_of_triangles(whole.attributes.texture_coordinates, whole.polygons);
  result.normals = values_of_triangles(whole.attributes.normals, whole.polygons);
  if (!result.materials.empty())
  {
    result.materials.clear();
    for (std::size_t face = 0; face < whole.polygons.size(); ++face)
      for_each_triangle(whole.polygons[face], [&](auto, auto, auto)
                        { result.materials.push_back(whole.attributes.materials[face]); });
  }
  return result;
}

Surface_attributes attributes_of_pieces(const Polygon_soup& whole,
                                        const Polygon_soup& pieces,
                                        const std::vector<std::size_t>& old_faces)
{
  const Pieces of_faces(whole, pieces, old_faces);
  Surface_attributes result;
  result.texture_coordinates = of_faces.values(whole.attributes.texture_coordinates);
  result.normals = of_faces.values(whole.attributes.normals);
  result.colors = of_faces.colors();
  if (!whole.attributes.materials.empty())
  {
    for (const std::size_t face : old_faces)
      result.materials.push_back(whole.attributes.materials[face]);
    result.materials.resize(pieces.polygons.size(), no_index);
  }
  result.material_names = whole.attributes.material_names;
  result.material_files = whole.attributes.material_files;
  result.gltf_materials = whole.attributes.gltf_materials;
  return result;
}

} // namespace tool
