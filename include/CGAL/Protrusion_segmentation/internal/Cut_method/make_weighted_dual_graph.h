// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_WEIGHTED_DUAL_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_WEIGHTED_DUAL_GRAPH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/rounded_normals.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/smooth_normals.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Six times the signed volume of a closed surface. Of one with borders it is taken as if every border were
// closed by a fan around the origin, which lies in the middle of the surface.
inline double signed_volume(const Indexed_surface& surface, bool is_parallel)
{
  const Indexed_surface::Point_3 origin(0, 0, 0);
  return add_blocks(surface.number_of_faces(), is_parallel, 0.,
                    [&](std::size_t begin, std::size_t end)
                    {
                      double volume = 0;
                      for (std::size_t i = begin; i < end; ++i)
                      {
                        const Indexed_surface::Index f = static_cast<Indexed_surface::Index>(i);
                        volume += surface.area_vector(f) * (surface.centroid(f) - origin);
                      }
                      return volume;
                    });
}

// The centre of gravity.
inline Indexed_surface::Point_3 centroid(const Indexed_surface& surface)
{
  const Indexed_surface::Point_3 origin(0, 0, 0);
  Indexed_surface::Vector_3 moment(0, 0, 0);
  for (Indexed_surface::Index f = 0; f < surface.number_of_faces(); ++f)
    moment += surface.area(f) * (surface.centroid(f) - origin);
  return surface.area() > 0 ? origin + moment / surface.area() : origin;
}

// Makes the dual graph of a surface in two steps: what is measured on the faces, then the weights of its seams. An edge is
// concave if the smoothed normals of its two faces lean towards each other; which side is inside is decided by the sign of
// the volume.
class Weighted_dual_graph_maker
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  // The arguments must outlive the object; the graph is empty.
  Weighted_dual_graph_maker(const Indexed_surface& surface,
                            const Cut_policy& policy,
                            Execution& execution,
                            Weighted_dual_graph& graph)
    : m_surface(surface),
      m_policy(policy),
      m_execution(execution),
      m_graph(graph),
      m_unit(surface.area() > 0 ? std::sqrt(surface.area()) : 1)
  {
    m_graph.length_of_angle = policy.length_of_angle();
    m_graph.is_flat = is_flat(surface, execution.is_parallel());
    m_outward = !m_graph.is_flat && signed_volume(surface, execution.is_parallel()) < 0 ? -1 : 1;
  }

  // All but curvatures and capacities.
  void measure()
  {
    call_both(m_execution.is_parallel(), [this] { number_arcs(); }, [this] { m_centre = centroid(m_surface); });
    for_each_face([this](Index f) { measure(f); });
  }

  // Curvatures and capacities, of what is measured, which stays as it is.
  void weigh()
  {
    const Diffusion::Values normals = m_graph.is_flat
                                        ? Rounded_normals(m_surface, m_graph, m_execution)()
                                        : smooth_normals(m_graph, this->normals(), normal_radius, m_execution);
    for (std::vector<float>* weights : {&m_graph.curvature, &m_graph.capacity})
      weights->resize(m_graph.target.size());
    for_each_face(
      [&](Index f)
      {
        for (Index arc : m_graph.arcs(f))
          weigh(f, arc, normals);
      });
  }

private:
  // In units of the square root of the area of the surface. Chosen on half of the development models of the
  // Princeton benchmark; all lie on plateaus.
  // Radius over which normals are averaged; between .015 and .05 without effect.
  static constexpr double normal_radius = 0.03;
  // Curvature beyond it, a radius of 1/60, is tessellation.
  static constexpr double largest_curvature = 60;
  // Centroids in one place must not make an infinite curvature.
  static constexpr double least_length = 1e-9;

  template <typename Visit>
  void for_each_face(Visit visit) const
  {
    for_each_block(m_surface.number_of_faces(), m_execution.is_parallel(),
                   [&](std::size_t begin, std::size_t end, std::size_t)
                   {
                     for (std::size_t f = begin; f < end; ++f)
                       visit(static_cast<Index>(f));
                   });
  }

  void number_arcs()
  {
    const Index n = m_surface.number_of_faces();
    m_graph.first_arc.reserve(n + 1);
    Index number_of_arcs = 0;
    for (Index f = 0; f < n; ++f)
    {
      for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
        number_of_arcs += m_surface.neighbor(c) != Indexed_surface::no_face();
      m_graph.first_arc.push_back(number_of_arcs);
    }
    m_graph.area.resize(n);
    m_graph.centre.resize(n);
    m_graph.target.resize(number_of_arcs);
    m_graph.length.resize(number_of_arcs);
    m_graph.border_length.resize(number_of_arcs);
  }

  void measure(Index f)
  {
    m_graph.area[f] = m_surface.area(f) / (m_unit * m_unit);
    m_graph.set_centre(f, Indexed_surface::Point_3(0, 0, 0) + (m_surface.centroid(f) - m_centre) / m_unit);
    Index arc = m_graph.first_arc[f];
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
      if (m_surface.neighbor(c) != Indexed_surface::no_face())
        measure_arc(arc++, f, c);
  }

  void measure_arc(Index arc, Index f, Index corner)
  {
    const Index g = m_surface.neighbor(corner);
    const double length = std::sqrt((m_surface.centroid(g) - m_surface.centroid(f)).squared_length()) / m_unit;
    m_graph.target[arc] = g;
    m_graph.length[arc] = static_cast<float>((std::max)(length, least_length));
    m_graph.border_length[arc] = static_cast<float>(m_surface.edge_length(f, corner) / m_unit);
  }

  Diffusion::Values normals() const
  {
    Diffusion::Values result(m_surface.number_of_faces(), {0, 0, 0});
    for_each_face(
      [&](Index f)
      {
        if (m_surface.area(f) > 0)
          result[f] = triple(m_surface.area_vector(f) / m_surface.area(f));
      });
    return result;
  }

  void weigh(Index f, Index arc, const Diffusion::Values& normals)
  {
    const Index g = m_graph.target[arc];
    const Diffusion::Triple &n = normals[f], &m = normals[g];
    const Vector_3 turn(m[0] - n[0], m[1] - n[1], m[2] - n[2]);
    // by the chord: the cosine of a small angle knows little of it
    const double angle = 2 * std::asin((std::min)(1., std::sqrt(turn.squared_length()) / 2));
    const bool is_concave = m_outward * (turn * (m_surface.centroid(g) - m_surface.centroid(f))) < 0;
    const double strength = (std::min)(largest_curvature, angle / m_graph.length[arc]);
    const double curvature = is_concave ? strength : -strength;
    m_graph.curvature[arc] = static_cast<float>(curvature);
    m_graph.capacity[arc] = static_cast<float>(m_policy.cost(m_graph.border_length[arc], curvature));
  }

  const Indexed_surface& m_surface;
  const Cut_policy& m_policy;
  Execution& m_execution;
  Weighted_dual_graph& m_graph;
  double m_unit;
  Indexed_surface::Point_3 m_centre = Indexed_surface::Point_3(0, 0, 0);
  double m_outward;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_WEIGHTED_DUAL_GRAPH_H
