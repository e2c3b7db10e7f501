// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_WEIGHTED_DUAL_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_WEIGHTED_DUAL_GRAPH_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_ingredients.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/smooth_normals.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The constants of the weights, in units of the square root of the area of the surface. Chosen on half of the
// development models of the Princeton benchmark; all lie on plateaus.
struct Seam_constants
{
  // Radius over which normals are averaged; between .015 and .05 without effect.
  static constexpr double normal_radius = 0.03;
  // A cut along a seam of concave curvature c costs least + (1 - least) exp(-decay c) per unit of length.
  static constexpr double least_cost = 0.02;
  static constexpr double cost_decay = 0.1;
  // How much less a convex seam counts: a ridge is a better border than a flat place.
  static constexpr double convex_share = 0.2;
  // Concave curvature from which on an edge lies in a seam, a radius of 1/2.
  static constexpr double seam_curvature = 2;
  // Curvature beyond it, a radius of 1/60, is tessellation.
  static constexpr double largest_curvature = 60;
};

// What a cut costs per unit of its length.
inline double cost_of_seam(double curvature)
{
  using Constants = Seam_constants;
  const double strength = curvature > 0 ? curvature : -curvature * Constants::convex_share;
  return Constants::least_cost + (1 - Constants::least_cost) * std::exp(-Constants::cost_decay * strength);
}

// Six times the signed volume of a closed surface. Of one with borders it is taken as if every border were
// closed by a fan around the centre of the surface's box, which is the origin.
inline double signed_volume(const Indexed_surface& part)
{
  double volume = 0;
  const Indexed_surface::Point_3 origin(0, 0, 0);
  for (Indexed_surface::Index f = 0; f < part.number_of_faces(); ++f)
    volume += part.area_vector(f) * (part.centroid(f) - origin);
  return volume;
}

// The dual graph of a surface with the weights of its seams. An edge is concave if the smoothed normals of
// its two faces lean towards each other; which side is inside is decided by the sign of the volume.
inline Weighted_dual_graph make_weighted_dual_graph(const Indexed_surface& part, const Cut_ingredients& ingredients = {})
{
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;
  using Constants = Seam_constants;
  const double unit = part.area() > 0 ? std::sqrt(part.area()) : 1;
  const double outward = signed_volume(part) < 0 ? -1 : 1;
  const std::vector<Vector_3> normals = smooth_normals(part, Constants::normal_radius * unit);

  Weighted_dual_graph graph;
  if (!ingredients.cost_of_seams)
    graph.length_of_angle = 0;
  graph.first_arc.reserve(part.number_of_faces() + 1);
  for (std::vector<float>* weights :
       {&graph.length, &graph.curvature, &graph.border_length, &graph.concave_border_length, &graph.capacity})
    weights->reserve(part.number_of_corners());
  graph.target.reserve(part.number_of_corners());
  graph.area.reserve(part.number_of_faces());
  graph.centre.reserve(part.number_of_faces());
  for (Index f = 0; f < part.number_of_faces(); ++f)
  {
    graph.area.push_back(part.area(f) / (unit * unit));
    graph.add_centre(Indexed_surface::Point_3(0, 0, 0) +
                     (part.centroid(f) - Indexed_surface::Point_3(0, 0, 0)) / unit);
    for (Index c = part.first_corner(f); c < part.first_corner(f + 1); ++c)
    {
      const Index g = part.neighbor(c);
      if (g == Indexed_surface::no_face())
        continue;
      const Vector_3 step = part.centroid(g) - part.centroid(f);
      const double length = (std::max)(std::sqrt(step.squared_length()) / unit, 1e-9);
      const double border = part.edge_length(f, c) / unit;
      const double cosine = (std::min)(1., (std::max)(-1., normals[f] * normals[g]));
      const bool is_concave = outward * ((normals[g] - normals[f]) * step) < 0;
      const double strength = (std::min)(Constants::largest_curvature, std::acos(cosine) / length);
      const double curvature = is_concave ? strength : -strength;
      graph.target.push_back(g);
      graph.length.push_back(static_cast<float>(length));
      graph.curvature.push_back(static_cast<float>(curvature));
      graph.border_length.push_back(static_cast<float>(border));
      graph.concave_border_length.push_back(
        static_cast<float>(curvature > Constants::seam_curvature ? border : 0));
      graph.capacity.push_back(
        static_cast<float>(ingredients.cost_of_seams ? border * cost_of_seam(curvature) : border));
    }
    graph.first_arc.push_back(static_cast<Index>(graph.target.size()));
  }
  return graph;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MAKE_WEIGHTED_DUAL_GRAPH_H
