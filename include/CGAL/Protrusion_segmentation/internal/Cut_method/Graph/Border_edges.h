// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_BORDER_EDGES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_BORDER_EDGES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The edges of the border of a surface, or of its outline: of the border and of the faces beside rims.
class Border_edges
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  struct Edge
  {
    Index face, from, to; // the latter are vertices
    Vector_3 vector;

    double length() const { return std::sqrt(vector.squared_length()); }
  };

  // `is_rim`: of each face, if there are rims
  explicit Border_edges(const Indexed_surface& surface, const std::vector<bool>& is_rim = {})
  {
    const auto ends = [&](Index face, Index neighbor)
    { return neighbor == Indexed_surface::no_face() || (!is_rim.empty() && is_rim[neighbor] && !is_rim[face]); };
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
        if (ends(f, surface.neighbor(c)))
        {
          const Index from = surface.vertex(c), to = surface.vertex(surface.next_corner(f, c));
          m_edges.push_back({f, from, to, surface.point(to) - surface.point(from)});
        }
    if (m_edges.empty())
      return;
    m_edge_from.resize(surface.number_of_vertices(), none);
    m_edge_to.resize(surface.number_of_vertices(), none);
    for (Index e = 0; e < m_edges.size(); ++e)
      m_edge_from[m_edges[e].from] = m_edge_to[m_edges[e].to] = e;
  }

  const std::vector<Edge>& operator()() const { return m_edges; }

  // For each edge the connected part of the border that it lies on, by one of its vertices.
  std::vector<Index> parts() const
  {
    Disjoint_sets sets(static_cast<Index>(m_edge_from.size()));
    for (const Edge& edge : m_edges)
      sets.union_set(edge.from, edge.to);
    std::vector<Index> result;
    for (const Edge& edge : m_edges)
      result.push_back(sets.find_set(edge.from));
    return result;
  }

  // The chord of the border from `reach` before to `reach` after the middle of an edge, scaled to the length of the edge.
  Vector_3 straight(std::size_t edge, double reach) const
  {
    const Vector_3 own = m_edges[edge].vector;
    const double length = m_edges[edge].length();
    Vector_3 chord = own;
    for (bool is_forward : {false, true})
    {
      double rest = reach - length / 2;
      for (Index e = next(edge, is_forward); e != none && e != edge && rest > 0; e = next(e, is_forward))
      {
        const double step = (std::max)(m_edges[e].length(), least_step * reach);
        chord += m_edges[e].vector * (std::min)(1., rest / step);
        rest -= step;
      }
    }
    const double size = std::sqrt(chord.squared_length());
    return size > 0 ? chord * (length / size) : own;
  }

private:
  static constexpr Index none = Indexed_surface::no_face();
  static constexpr double least_step = 1e-3; // that of an edge of no length

  Index next(std::size_t edge, bool is_forward) const
  {
    return is_forward ? m_edge_from[m_edges[edge].to] : m_edge_to[m_edges[edge].from];
  }

  std::vector<Edge> m_edges;
  std::vector<Index> m_edge_from, m_edge_to; // of every vertex of the surface, if it is open
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_BORDER_EDGES_H
