// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_AVERAGE_NORMALS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_AVERAGE_NORMALS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/diffusion.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Protrusion_segmentation::internal {

// Whether the surface has a border.
inline bool is_open(const Indexed_surface& surface)
{
  for (Indexed_surface::Index f = 0; f < surface.number_of_faces(); ++f)
    for (Indexed_surface::Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      if (surface.neighbor(c) == Indexed_surface::no_face())
        return true;
  return false;
}

// Leans the normals of an open surface as if it were inflated, its border held: of a sheet only the outline shows what sticks
// out, of a scan from one side much of it. The square of the height is twice the solution h of a screened Poisson equation,
// (1 - r^2 Laplace) h = r^2, h = 0 at the border, of which a strip becomes half a round tube and a disc half an ellipsoid. Farther
// from the border than the radius r the surface stays as it is.
class Inflation
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  Inflation(const Indexed_surface& surface, Execution& execution)
    : m_surface(surface), m_execution(execution), m_unit(std::sqrt(surface.area()))
  {}

  // `graph` is the dual graph of the surface, `centre` its centres; `outward`: 1 if normals point out of the body, else -1
  void operator()(const Dual_graph& graph, const Centres& centre, double outward, Triples& normals) const
  {
    const std::vector<float> height = heights(graph, centre);
    for_each_number(normals.size(), m_execution.is_parallel(),
                    [&](Index f)
                    {
                      const Vector_3 normal(normals[f][0], normals[f][1], normals[f][2]);
                      normals[f] = triple(normal - outward * slope(f, height));
                    });
  }

private:
  // In units of the square root of the area.
  std::vector<float> heights(const Dual_graph& graph, const Centres& centre) const
  {
    constexpr double radius = 0.2;    // between .15 and .3 without much effect
    constexpr double flattened = 0.07; // the rim rises with a finite slope: outlines are jagged
    constexpr double largest_group = 0.02;
    std::vector<float> losses(m_surface.number_of_faces(), 0);
    for_each_number(losses.size(), m_execution.is_parallel(), [&](Index f) { losses[f] = conductance_to_border(f); });
    Triples solution(m_surface.number_of_faces(), {1, 0, 0});
    const double radius_of_disc = std::sqrt(8.) * radius; // see Multilevel_diffusion
    Multilevel_diffusion(radius_of_disc, m_execution, largest_group)(graph, centre, solution, losses);
    std::vector<float> result;
    for (const Triple& t : solution)
      result.push_back(static_cast<float>(
        std::sqrt(2 * CGAL::square(radius) * (std::max)(0.f, t[0]) + CGAL::square(flattened)) - flattened));
    return result;
  }

  float conductance_to_border(Index f) const
  {
    constexpr double least_distance = 1e-3; // of the centroid from the edge, relative to its length
    double sum = 0;
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
      if (m_surface.neighbor(c) == Indexed_surface::no_face())
      {
        const Vector_3 edge = edge_vector(f, c);
        const double squared_length = edge.squared_length();
        const double twice_area = std::sqrt(
          cross_product(edge, m_surface.centroid(f) - m_surface.point(m_surface.vertex(c))).squared_length());
        if (squared_length > 0)
          sum += 1 / (std::max)(least_distance, twice_area / squared_length);
      }
    return static_cast<float>(sum);
  }

  // The gradient of the height in a face, by the heights halfway to its neighbors.
  Vector_3 slope(Index f, const std::vector<float>& height) const
  {
    Vector_3 sum(0, 0, 0);
    if (!(m_surface.area(f) > 0))
      return sum;
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
    {
      const Index g = m_surface.neighbor(c);
      const double rise = g == Indexed_surface::no_face() ? -height[f] : (height[g] - height[f]) / 2;
      sum += rise * cross_product(edge_vector(f, c), m_surface.area_vector(f));
    }
    return sum * (m_unit / CGAL::square(m_surface.area(f)));
  }

  Vector_3 edge_vector(Index f, Index corner) const
  {
    return m_surface.point(m_surface.vertex(m_surface.next_corner(f, corner))) - m_surface.point(m_surface.vertex(corner));
  }

  const Indexed_surface& m_surface;
  Execution& m_execution;
  double m_unit;
};

// Scales each vector to length 1; where it vanishes, it stays the zero vector.
inline void normalize(Triples& vectors, bool is_parallel)
{
  for_each_number(vectors.size(), is_parallel,
                  [&](std::size_t i)
                  {
                    Triple& v = vectors[i];
                    const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
                    for (float& x : v)
                      x = length > 0 ? x / length : 0;
                  });
}

// The unit normals of the faces, each the average over a radius around it. `graph` is the dual graph of the surface;
// `outward`: 1 if they point out of the body, else -1
inline Triples average_normals(const Indexed_surface& surface,
                               const Dual_graph& graph,
                               const Centres& centre,
                               double outward,
                               Execution& execution)
{
  // in units of the square root of the area; between .015 and .05 without effect
  constexpr double normal_radius = 0.03;
  Triples normals(surface.number_of_faces(), {0, 0, 0});
  for_each_number(normals.size(), execution.is_parallel(),
                  [&](Indexed_surface::Index f)
                  {
                    if (surface.area(f) > 0)
                      normals[f] = triple(surface.area_vector(f) / surface.area(f));
                  });
  if (is_open(surface))
    Inflation(surface, execution)(graph, centre, outward, normals);
  Multilevel_diffusion(normal_radius, execution)(graph, centre, normals);
  normalize(normals, execution.is_parallel());
  return normals;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_AVERAGE_NORMALS_H
