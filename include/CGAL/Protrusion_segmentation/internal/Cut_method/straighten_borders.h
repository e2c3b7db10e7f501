// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_STRAIGHTEN_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_STRAIGHTEN_BORDERS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Measures the borders between the nodes of a coarse graph as if they were straight. They run along edges, in a zigzag
// that is the longer the less the edges lie in their direction: of finer triangles a longer one, though the surface is
// the same. What counts is how far an edge gets along the chord of its border: so much of its length, of its seam and
// of its cost is kept.
class Border_straightener
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  // `fine` is the dual graph of the surface, `node` the node of every face in the coarse graph.
  Border_straightener(const Indexed_surface& surface,
                      const Weighted_dual_graph& fine,
                      const std::vector<Index>& node,
                      Weighted_dual_graph& coarse)
    : m_surface(surface), m_fine(fine), m_node(node), m_coarse(coarse), m_sums(coarse.target.size())
  {}

  void operator()(bool is_parallel)
  {
    const Index_groups faces(m_node, m_coarse.number_of_nodes());
    for_each_index(m_coarse.number_of_nodes(), is_parallel,
                   [&](std::size_t i)
                   {
                     const auto visit = [&](auto add)
                     {
                       for (Index f : faces[i])
                         for_each_border_edge(f, add);
                     };
                     visit([this](Index arc, Index, const Vector_3& edge) { m_sums[arc].chord += edge; });
                     visit([this](Index arc, Index old, const Vector_3& edge) { add_edge(arc, old, edge); });
                   });
    for (Index i = 0; i < m_coarse.number_of_nodes(); ++i)
      for (Index arc : m_coarse.arcs(i))
        if (const Index j = m_coarse.target[arc]; i < j)
          straighten(arc, m_coarse.arc_between(j, i));
  }

private:
  // What borders keep of their length at least. One that is shorter from end to end is bent, around a node for instance,
  // so that the chord is no measure; its weights shrink alike. With .5, .7 and .8 the Rand index error on the
  // development models of the Princeton benchmark is the same, and with .8 segments depend least on the triangles.
  static constexpr double least_share_of_length = 0.8;

  struct Sums
  {
    Vector_3 chord{0, 0, 0};
    double along = 0;         // how far the edges get along the chord, to and fro
    double concave_along = 0; // those in concave seams
    double cost_along = 0;    // times what a unit of their length costs
  };

  // Calls `visit(arc, old, edge)` for the edges of a face that lie between nodes: with the arc between the nodes, that
  // between the faces, and the edge in the orientation of the face.
  template <typename Visit>
  void for_each_border_edge(Index f, Visit visit) const
  {
    Index old = m_fine.first_arc[f];
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
    {
      const Index g = m_surface.neighbor(c);
      if (g == Indexed_surface::no_face())
        continue;
      if (m_node[g] != m_node[f])
        visit(m_coarse.arc_between(m_node[f], m_node[g]), old,
              m_surface.point(m_surface.vertex(m_surface.next_corner(f, c))) - m_surface.point(m_surface.vertex(c)));
      ++old;
    }
  }

  void add_edge(Index arc, Index old, const Vector_3& edge)
  {
    Sums& sums = m_sums[arc];
    const double along = std::abs(edge * sums.chord);
    sums.along += along;
    if (!(m_fine.border_length[old] > 0))
      return;
    sums.concave_along += along * m_fine.concave_border(old) / m_fine.border_length[old];
    sums.cost_along += along * m_fine.capacity[old] / m_fine.border_length[old];
  }

  // Both arcs of a border get the same weights, to the last digit.
  void straighten(Index arc, Index opposite)
  {
    const Sums& sums = m_sums[arc];
    const double unit = m_surface.area() > 0 ? std::sqrt(m_surface.area()) : 1;
    const double old_length = m_coarse.border_length[arc], chord = std::sqrt(sums.chord.squared_length()) / unit;
    double length = (std::min)(old_length, chord), concave = 0, cost = 0;
    if (chord >= least_share_of_length * old_length && sums.along > 0)
    {
      concave = length * sums.concave_along / sums.along;
      cost = length * sums.cost_along / sums.along;
    }
    else
    {
      length = least_share_of_length * old_length;
      concave = least_share_of_length * m_coarse.concave_border_length[arc];
      cost = least_share_of_length * m_coarse.capacity[arc];
    }
    for (Index a : {arc, opposite})
    {
      m_coarse.border_length[a] = static_cast<float>(length);
      m_coarse.concave_border_length[a] = static_cast<float>(concave);
      m_coarse.capacity[a] = static_cast<float>(cost);
    }
  }

  const Indexed_surface& m_surface;
  const Weighted_dual_graph& m_fine;
  const std::vector<Index>& m_node;
  Weighted_dual_graph& m_coarse;
  std::vector<Sums> m_sums; // of every arc
};

// Linear time.
inline void straighten_borders(const Indexed_surface& surface,
                               const Weighted_dual_graph& fine,
                               const std::vector<Indexed_surface::Index>& node,
                               Weighted_dual_graph& coarse,
                               bool is_parallel = false)
{
  Border_straightener(surface, fine, node, coarse)(is_parallel);
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_STRAIGHTEN_BORDERS_H
