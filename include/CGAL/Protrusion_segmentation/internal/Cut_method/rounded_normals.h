// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_ROUNDED_NORMALS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_ROUNDED_NORMALS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/smooth_normals.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

inline Indexed_surface::Vector_3 area_vector(const Indexed_surface& surface, bool is_parallel = false)
{
  return add_blocks(surface.number_of_faces(), is_parallel, Indexed_surface::Vector_3(0, 0, 0),
                    [&](std::size_t begin, std::size_t end)
                    {
                      Indexed_surface::Vector_3 sum(0, 0, 0);
                      for (std::size_t f = begin; f < end; ++f)
                        sum += surface.area_vector(static_cast<Indexed_surface::Index>(f));
                      return sum;
                    });
}

// Whether all faces of a surface have the same normal: a sheet cut out of a plane.
inline bool is_flat(const Indexed_surface& surface, bool is_parallel = false)
{
  // Of the area, what may be lost when it is seen from the front: normals differ by less than a tenth of a degree.
  constexpr double largest_loss = 1e-6;
  return surface.area() > 0 &&
         std::sqrt(area_vector(surface, is_parallel).squared_length()) >= (1 - largest_loss) * surface.area();
}

// Normals of a flat surface as if it were rounded off towards its border: there they lean outwards, the less the farther
// they are from it. Nothing but the outline tells where such a surface sticks out. At its concave corners, the normals lean
// towards each other: a seam, as there is between an arm and a body.
class Rounded_normals
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  // `graph` is the dual graph of the surface.
  Rounded_normals(const Indexed_surface& surface, const Weighted_dual_graph& graph, Execution& execution)
    : m_surface(surface), m_graph(graph), m_execution(execution), m_normal(area_vector(surface) / surface.area())
  {}

  Diffusion::Values operator()() const
  {
    Diffusion::Values normals = directions_at_border();
    Multilevel_diffusion(radius, m_execution)(m_graph, normals);
    for (Diffusion::Triple& normal : normals)
    {
      const Vector_3 sum = m_normal + Vector_3(normal[0], normal[1], normal[2]);
      normal = triple(sum / std::sqrt(sum.squared_length()));
    }
    return normals;
  }

private:
  // How far from the border normals lean, in units of the square root of the area. With a half of it, cuts through a trunk are
  // found between two concave places far from each other; with twice as much, arms of a star are no longer cut off.
  static constexpr double radius = 0.2;

  // Outwards in the faces at the border, so much for each edge that after diffusion, by which it thins out over the
  // radius, there is a direction of length 2 all along a straight border.
  Diffusion::Values directions_at_border() const
  {
    const double unit = std::sqrt(m_surface.area());
    Diffusion::Values result(m_surface.number_of_faces(), {0, 0, 0});
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
  const Weighted_dual_graph& m_graph;
  Execution& m_execution;
  Vector_3 m_normal;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_ROUNDED_NORMALS_H
