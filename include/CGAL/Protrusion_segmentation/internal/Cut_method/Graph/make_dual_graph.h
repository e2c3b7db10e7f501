// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_MAKE_DUAL_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_MAKE_DUAL_GRAPH_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Protrusion_segmentation::internal {

// The centroids of the faces, around the centre of gravity of the surface and in units of the square root of its area.
inline Centres centres_of_faces(const Indexed_surface& surface, bool is_parallel)
{
  const Indexed_surface::Point_3 origin(0, 0, 0);
  Indexed_surface::Vector_3 moment(0, 0, 0);
  for (Indexed_surface::Index f = 0; f < surface.number_of_faces(); ++f)
    moment += surface.area(f) * (surface.centroid(f) - origin);
  const Indexed_surface::Point_3 middle = surface.area() > 0 ? origin + moment / surface.area() : origin;
  const double unit = unit_of_length(surface);
  Centres centres(surface.number_of_faces());
  for_each_number(centres.size(), is_parallel, [&](Indexed_surface::Index f)
                  { centres[f] = centre(origin + (surface.centroid(f) - middle) / unit); });
  return centres;
}

// The dual graph of a surface: one node a face, one arc from each side of an edge.
class Dual_graph_maker
{
public:
  using Index = Indexed_surface::Index;

  explicit Dual_graph_maker(const Indexed_surface& surface) : m_surface(surface), m_unit(unit_of_length(surface)) {}

  void operator()(Dual_graph& graph, bool is_parallel) const
  {
    number_arcs(graph);
    for_each_number(m_surface.number_of_faces(), is_parallel, [&](Index f) { measure(f, graph); });
  }

private:
  void number_arcs(Dual_graph& graph) const
  {
    const Index n = m_surface.number_of_faces();
    graph.first_arc.reserve(n + 1);
    Index number_of_arcs = 0;
    for (Index f = 0; f < n; ++f)
    {
      for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
        number_of_arcs += m_surface.neighbor(c) != Indexed_surface::no_face();
      graph.first_arc.push_back(number_of_arcs);
    }
    graph.area.resize(n);
    graph.target.resize(number_of_arcs);
    graph.length.resize(number_of_arcs);
    graph.border_length.resize(number_of_arcs);
  }

  void measure(Index f, Dual_graph& graph) const
  {
    graph.area[f] = m_surface.area(f) / (m_unit * m_unit);
    Index arc = graph.first_arc[f];
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
      if (m_surface.neighbor(c) != Indexed_surface::no_face())
        measure_arc(arc++, f, c, graph);
  }

  void measure_arc(Index arc, Index f, Index corner, Dual_graph& graph) const
  {
    constexpr double least_length = 1e-9; // centroids in one place must not make an infinite curvature
    const Index g = m_surface.neighbor(corner);
    const double length = std::sqrt((m_surface.centroid(g) - m_surface.centroid(f)).squared_length()) / m_unit;
    graph.target[arc] = g;
    graph.length[arc] = static_cast<float>((std::max)(length, least_length));
    graph.border_length[arc] = static_cast<float>(m_surface.edge_length(f, corner) / m_unit);
  }

  const Indexed_surface& m_surface;
  double m_unit;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_MAKE_DUAL_GRAPH_H
