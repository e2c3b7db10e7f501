// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_WEIGHTED_DUAL_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_WEIGHTED_DUAL_GRAPH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/smooth_normals.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Six times the signed volume of a closed surface. Of one with borders it is taken as if every border were
// closed by a fan around the centre of the surface's box, which is the origin.
inline double signed_volume(const Indexed_surface& surface)
{
  double volume = 0;
  const Indexed_surface::Point_3 origin(0, 0, 0);
  for (Indexed_surface::Index f = 0; f < surface.number_of_faces(); ++f)
    volume += surface.area_vector(f) * (surface.centroid(f) - origin);
  return volume;
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

// The dual graph of a surface with the weights of its seams. An edge is concave if the smoothed normals of
// its two faces lean towards each other; which side is inside is decided by the sign of the volume.
class Weighted_dual_graph_maker
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  Weighted_dual_graph_maker(const Indexed_surface& surface, const Cut_policy& policy, Execution& execution)
    : m_surface(surface),
      m_policy(policy),
      m_unit(surface.area() > 0 ? std::sqrt(surface.area()) : 1),
      m_centre(centroid(surface)),
      m_outward(signed_volume(surface) < 0 ? -1 : 1),
      m_normals(smooth_normals(surface, normal_radius * m_unit, execution))
  {
    m_graph.length_of_angle = policy.length_of_angle();
    m_graph.reserve(surface.number_of_faces(), surface.number_of_corners());
  }

  Weighted_dual_graph operator()()
  {
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
    {
      m_graph.area.push_back(m_surface.area(f) / (m_unit * m_unit));
      m_graph.add_centre(Indexed_surface::Point_3(0, 0, 0) + (m_surface.centroid(f) - m_centre) / m_unit);
      for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
        if (m_surface.neighbor(c) != Indexed_surface::no_face())
          add_arc(f, c);
      m_graph.first_arc.push_back(static_cast<Index>(m_graph.target.size()));
    }
    return std::move(m_graph);
  }

private:
  // In units of the square root of the area of the surface. Chosen on half of the development models of the
  // Princeton benchmark; all lie on plateaus.
  // Radius over which normals are averaged; between .015 and .05 without effect.
  static constexpr double normal_radius = 0.03;
  // Concave curvature from which on an edge lies in a seam, a radius of 1/2.
  static constexpr double seam_curvature = 2;
  // Curvature beyond it, a radius of 1/60, is tessellation.
  static constexpr double largest_curvature = 60;
  // Centroids in one place must not make an infinite curvature.
  static constexpr double least_length = 1e-9;

  void add_arc(Index f, Index corner)
  {
    const Index g = m_surface.neighbor(corner);
    const Vector_3 step = m_surface.centroid(g) - m_surface.centroid(f);
    const double length = (std::max)(std::sqrt(step.squared_length()) / m_unit, least_length);
    const double border = m_surface.edge_length(f, corner) / m_unit;
    const double cosine = (std::min)(1., (std::max)(-1., m_normals[f] * m_normals[g]));
    const bool is_concave = m_outward * ((m_normals[g] - m_normals[f]) * step) < 0;
    const double strength = (std::min)(largest_curvature, std::acos(cosine) / length);
    const double curvature = is_concave ? strength : -strength;
    m_graph.target.push_back(g);
    m_graph.length.push_back(static_cast<float>(length));
    m_graph.curvature.push_back(static_cast<float>(curvature));
    m_graph.border_length.push_back(static_cast<float>(border));
    m_graph.concave_border_length.push_back(static_cast<float>(curvature > seam_curvature ? border : 0));
    m_graph.capacity.push_back(static_cast<float>(m_policy.cost(border, curvature)));
  }

  const Indexed_surface& m_surface;
  const Cut_policy& m_policy;
  double m_unit;
  Indexed_surface::Point_3 m_centre;
  double m_outward;
  std::vector<Vector_3> m_normals;
  Weighted_dual_graph m_graph;
};

inline Weighted_dual_graph make_weighted_dual_graph(const Indexed_surface& surface,
                                                    const Cut_policy& policy,
                                                    Execution& execution)
{
  return Weighted_dual_graph_maker(surface, policy, execution)();
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_WEIGHTED_DUAL_GRAPH_H
