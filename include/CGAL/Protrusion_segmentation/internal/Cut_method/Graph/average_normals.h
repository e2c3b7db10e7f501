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

inline Indexed_surface::Vector_3 area_vector(const Indexed_surface& surface, bool is_parallel = false)
{
  return add_numbers(surface.number_of_faces(), is_parallel, Indexed_surface::Vector_3(0, 0, 0),
                     [&](Indexed_surface::Vector_3& sum, Indexed_surface::Index f) { sum += surface.area_vector(f); });
}

// Whether all faces of a surface have the same normal: a sheet cut out of a plane.
inline bool is_flat(const Indexed_surface& surface, bool is_parallel = false)
{
  // of the area, lost when it is seen from the front: normals differ by less than a tenth of a degree
  constexpr double largest_loss = 1e-6;
  return surface.area() > 0 &&
         std::sqrt(area_vector(surface, is_parallel).squared_length()) >= (1 - largest_loss) * surface.area();
}

// Normals of a flat surface as if it were rounded off towards its border: they lean outwards there, and less farther away.
// Only the outline of such a surface shows what sticks out. At its concave corners, normals lean towards each other: a seam.
class Rounded_normals
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  Rounded_normals(const Indexed_surface& surface, Execution& execution)
    : m_surface(surface), m_execution(execution), m_normal(area_vector(surface) / surface.area())
  {}

  // `graph` is the dual graph of the surface, `centre` its centres.
  Triples operator()(const Dual_graph& graph, const Centres& centre) const
  {
    Triples normals = directions_at_border();
    Multilevel_diffusion(radius, m_execution)(graph, centre, normals);
    for (Triple& normal : normals)
    {
      const Vector_3 sum = m_normal + Vector_3(normal[0], normal[1], normal[2]);
      normal = triple(sum / std::sqrt(sum.squared_length()));
    }
    return normals;
  }

private:
  // Distance from the border within which normals lean, in units of the square root of the area. With half of it trunks are
  // cut between distant concave places; with twice as much arms of a star are not cut off.
  static constexpr double radius = 0.2;

  // Outwards in the faces at the border. After diffusion over the radius a straight border has directions of length 2.
  Triples directions_at_border() const
  {
    const double unit = std::sqrt(m_surface.area());
    Triples result(m_surface.number_of_faces(), {0, 0, 0});
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
    {
      Vector_3 sum(0, 0, 0);
      for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
        if (m_surface.neighbor(c) == Indexed_surface::no_face())
          sum += cross_product(m_surface.point(m_surface.vertex(m_surface.next_corner(f, c))) -
                                 m_surface.point(m_surface.vertex(c)),
                               m_normal);
      if (m_surface.area(f) > 0)
        result[f] = triple(sum * (radius * unit / m_surface.area(f)));
    }
    return result;
  }

  const Indexed_surface& m_surface;
  Execution& m_execution;
  Vector_3 m_normal;
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

// The unit normals of the faces, each the average over a radius around it. `graph` is the dual graph of the surface.
inline Triples average_normals(const Indexed_surface& surface,
                               const Dual_graph& graph,
                               const Centres& centre,
                               bool is_flat,
                               Execution& execution)
{
  // in units of the square root of the area; between .015 and .05 without effect
  constexpr double normal_radius = 0.03;
  if (is_flat)
    return Rounded_normals(surface, execution)(graph, centre);
  Triples normals(surface.number_of_faces(), {0, 0, 0});
  for_each_number(normals.size(), execution.is_parallel(),
                  [&](Indexed_surface::Index f)
                  {
                    if (surface.area(f) > 0)
                      normals[f] = triple(surface.area_vector(f) / surface.area(f));
                  });
  Multilevel_diffusion(normal_radius, execution)(graph, centre, normals);
  normalize(normals, execution.is_parallel());
  return normals;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_AVERAGE_NORMALS_H
