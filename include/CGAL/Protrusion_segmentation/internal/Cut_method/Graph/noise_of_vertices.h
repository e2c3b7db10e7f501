// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_NOISE_OF_VERTICES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_NOISE_OF_VERTICES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/diffusion.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/opposite_corner.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// How far each vertex lies below the centroid of its neighbours, along the normal; 0 on the border. `normals`: of the faces
inline std::vector<double> heights_below_neighbors(const Indexed_surface& surface, const Padded_vectors& normals)
{
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;
  std::vector<Vector_3> to_neighbors(surface.number_of_vertices(), Vector_3(0, 0, 0)), normal(to_neighbors); // sums
  std::vector<Index> neighbors(to_neighbors.size(), 0);
  std::vector<bool> is_on_border(to_neighbors.size());
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
    {
      const Index v = surface.vertex(c), next = surface.vertex(surface.next_corner(f, c));
      to_neighbors[v] += surface.point(next) - surface.point(v);
      normal[v] += unpadded(normals[f]);
      ++neighbors[v];
      if (surface.neighbor(c) == Indexed_surface::no_face())
        is_on_border[v] = is_on_border[next] = true;
    }
  std::vector<double> heights(to_neighbors.size(), 0);
  for (std::size_t v = 0; v < heights.size(); ++v)
    if (const double size = std::sqrt(normal[v].squared_length()); size > 0 && !is_on_border[v])
      heights[v] = to_neighbors[v] * normal[v] / (size * neighbors[v]);
  return heights;
}

// Limits numbers to a few times the median of their sizes.
inline void limit_to_median(std::vector<double>& numbers, double times)
{
  std::vector<double> sizes;
  for (const double number : numbers)
    sizes.push_back(std::abs(number));
  const auto median = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), median, sizes.end());
  for (double& number : numbers)
    number = std::clamp(number, -times * *median, times * *median);
}

// How far each vertex was moved by itself, as in a scan: the standard deviation, in units of the square root of the area. Heights of
// neighbours then have opposite signs. Where a surface is curved or folded they agree, and more than those of the two vertices
// opposite to an edge. `normals`: of the faces, averaged
inline double noise_of_vertices(const Indexed_surface& surface, const Padded_vectors& normals)
{
  using Index = Indexed_surface::Index;
  constexpr double largest_height = 3; // medians; folds are higher
  // Expected between products, in units of the variance, for vertices with six neighbours: 2 / 36 - (2 / 36 - 2 / 6).
  constexpr double difference_by_noise = 1. / 3;
  std::vector<double> heights = heights_below_neighbors(surface, normals);
  if (heights.empty())
    return 0;
  limit_to_median(heights, largest_height);
  const auto height_beyond = [&](Index f, Index c) // of the vertex after an edge: in a triangle the opposite one
  { return heights[surface.vertex(surface.next_corner(f, surface.next_corner(f, c)))]; };
  double sum = 0;
  std::size_t edges = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
    {
      const Index g = surface.neighbor(c), d = f < g ? opposite_corner(surface, f, c) : Indexed_surface::no_face();
      if (d == Indexed_surface::no_face())
        continue;
      sum += height_beyond(f, c) * height_beyond(g, d) - heights[surface.vertex(c)] * heights[surface.vertex(d)];
      ++edges;
    }
  return sum > 0 ? std::sqrt(sum / (difference_by_noise * double(edges))) / unit_of_length(surface) : 0;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_NOISE_OF_VERTICES_H
