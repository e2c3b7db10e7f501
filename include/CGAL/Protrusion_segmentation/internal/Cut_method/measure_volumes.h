// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MEASURE_VOLUMES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MEASURE_VOLUMES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Adds to a coarse graph what openings of cuts and volumes of segments are measured with. `node` is the node of every
// face. Linear time.
inline void measure_volumes(const Indexed_surface& surface,
                            const std::vector<Indexed_surface::Index>& node,
                            Weighted_dual_graph& graph,
                            bool is_parallel = false)
{
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;
  const double unit = surface.area() > 0 ? std::sqrt(surface.area()) : 1;
  const auto position = [unit](const Indexed_surface::Point_3& p)
  { return (p - Indexed_surface::Point_3(0, 0, 0)) / unit; };

  graph.border_area.assign(graph.target.size(), Vector_3(0, 0, 0));
  graph.border_vector.assign(graph.target.size(), Vector_3(0, 0, 0));
  graph.border_moment.assign(graph.target.size(), Vector_3(0, 0, 0));
  std::vector<double> lengths(graph.target.size(), 0);
  graph.area_vector.assign(graph.number_of_nodes(), Vector_3(0, 0, 0));
  graph.flux.assign(graph.number_of_nodes(), 0);
  const auto add_corner = [&](Index f, Index c)
  {
    const Index g = surface.neighbor(c);
    if (g == Indexed_surface::no_face() || node[g] == node[f])
      return;
    const Index arc = graph.arc_between(node[f], node[g]);
    const Vector_3 a = position(surface.point(surface.vertex(c)));
    const Vector_3 b = position(surface.point(surface.vertex(surface.next_corner(f, c))));
    graph.border_area[arc] += cross_product(a, b) / 2;
    graph.border_vector[arc] += b - a;
    const double length = std::sqrt((b - a).squared_length());
    graph.border_moment[arc] += length * (a + b) / 2;
    lengths[arc] += length;
  };
  const Index_groups faces(node, graph.number_of_nodes());
  for_each_index(graph.number_of_nodes(), is_parallel,
                 [&](std::size_t i)
                 {
                   for (Index f : faces[i])
                   {
                     const Vector_3 area_vector = surface.area_vector(f) / (unit * unit);
                     graph.area_vector[i] += area_vector;
                     graph.flux[i] += area_vector * position(surface.centroid(f));
                     for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
                       add_corner(f, c);
                   }
                   for (Index arc : graph.arcs(static_cast<Index>(i)))
                     if (lengths[arc] > 0) // straight borders are shorter than their edges
                       graph.border_moment[arc] = graph.border_moment[arc] * (graph.border_length[arc] / lengths[arc]);
                 });
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MEASURE_VOLUMES_H
