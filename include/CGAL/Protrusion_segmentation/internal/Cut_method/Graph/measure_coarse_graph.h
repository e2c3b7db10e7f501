// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_MEASURE_COARSE_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_MEASURE_COARSE_GRAPH_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Calls `visit(corner, arc)` for the edges of a face that lie between nodes of a coarse graph: with the corner that the edge
// starts at and the arc of the coarse graph. `node`: of every face.
template <typename Visit>
void for_each_border_edge(const Indexed_surface& surface,
                          const std::vector<Indexed_surface::Index>& node,
                          const Dual_graph& coarse,
                          Indexed_surface::Index face,
                          Visit visit)
{
  for (Indexed_surface::Index c = surface.first_corner(face); c < surface.first_corner(face + 1); ++c)
  {
    const Indexed_surface::Index g = surface.neighbor(c);
    if (g != Indexed_surface::no_face() && node[g] != node[face])
      visit(c, coarse.arc_between(node[face], node[g]));
  }
}

// Measures the borders between the nodes of a coarse graph as if they were straight. They run along edges, in a zigzag
// that is longer for finer triangles, though the surface is the same. Only the progress of an edge along the chord of its
// border counts: that share of its length, seam and cost is kept.
class Border_straightener
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  // `fine` is the dual graph of the surface, `node` the node of every face in the coarse graph.
  Border_straightener(const Indexed_surface& surface,
                      const Seam_graph& fine,
                      const std::vector<Index>& node,
                      Seam_graph& coarse)
    : m_surface(surface), m_fine(fine), m_node(node), m_coarse(coarse), m_sums(coarse.target.size())
  {}

  void operator()(const Index_groups& faces_of_nodes, bool is_parallel)
  {
    for_each_index(m_coarse.number_of_nodes(), is_parallel,
                   [&](std::size_t i)
                   {
                     for (Index f : faces_of_nodes[i])
                       for_each_border_edge(m_surface, m_node, m_coarse, f,
                                            [&](Index c, Index arc) { m_sums[arc].chord += edge(f, c); });
                     for (Index f : faces_of_nodes[i])
                       for_each_border_edge(m_surface, m_node, m_coarse, f,
                                            [&](Index c, Index arc) { add_edge(arc, fine_arc(f, c), edge(f, c)); });
                   });
    for (Index i = 0; i < m_coarse.number_of_nodes(); ++i)
      for (Index arc : m_coarse.arcs(i))
        if (const Index j = m_coarse.target[arc]; i < j)
          straighten(arc, m_coarse.arc_between(j, i));
  }

private:
  // Borders keep at least that share of their length: one that is shorter from end to end is bent, and the chord is no
  // measure of it. From .5 to .8 errors are equal; with .8 segments depend least on the triangles.
  static constexpr double least_share_of_length = 0.8;

  struct Sums
  {
    Vector_3 chord{0, 0, 0};
    double along = 0;         // progress of the edges along the chord, to and fro
    double concave_along = 0; // of those in concave seams
    double cost_along = 0;    // times the cost of a unit of their length
  };

  Vector_3 edge(Index f, Index c) const
  {
    return m_surface.point(m_surface.vertex(m_surface.next_corner(f, c))) - m_surface.point(m_surface.vertex(c));
  }

  // the arc over the edge from a corner
  Index fine_arc(Index f, Index corner) const
  {
    Index arc = m_fine.first_arc[f];
    for (Index c = m_surface.first_corner(f); c < corner; ++c)
      arc += m_surface.neighbor(c) != Indexed_surface::no_face();
    return arc;
  }

  void add_edge(Index arc, Index old, const Vector_3& edge)
  {
    Sums& sums = m_sums[arc];
    const double along = std::abs(edge * sums.chord);
    sums.along += along;
    if (!(m_fine.border_length[old] > 0))
      return;
    sums.concave_along += along * m_fine.length_in_seam(old) / m_fine.border_length[old];
    sums.cost_along += along * m_fine.capacity[old] / m_fine.border_length[old];
  }

  // Both arcs of a border get the same weights, to the last digit.
  void straighten(Index arc, Index opposite)
  {
    const Sums& sums = m_sums[arc];
    const double old_length = m_coarse.border_length[arc];
    const double chord = std::sqrt(sums.chord.squared_length()) / unit_of_length(m_surface);
    double length = (std::min)(old_length, chord), concave = 0, cost = 0;
    if (chord >= least_share_of_length * old_length && sums.along > 0)
    {
      concave = length * sums.concave_along / sums.along;
      cost = length * sums.cost_along / sums.along;
    }
    else
    {
      length = least_share_of_length * old_length;
      concave = least_share_of_length * m_coarse.concave_length[arc];
      cost = least_share_of_length * m_coarse.capacity[arc];
    }
    for (Index a : {arc, opposite})
    {
      m_coarse.border_length[a] = static_cast<float>(length);
      m_coarse.concave_length[a] = static_cast<float>(concave);
      m_coarse.capacity[a] = static_cast<float>(cost);
    }
  }

  const Indexed_surface& m_surface;
  const Seam_graph& m_fine;
  const std::vector<Index>& m_node;
  Seam_graph& m_coarse;
  std::vector<Sums> m_sums; // of every arc
};

// How rough a surface is: the concave curvature of the borders, averaged as the square of a mean root, in which many valleys count
// more than deep ones. Edges that are sharper than a radius of 1/30 belong to what was built, as teeth of gears do.
inline double roughness(const Seam_graph& coarse)
{
  constexpr double largest_curvature = 30;
  double length = 0, roots = 0;
  for (std::size_t arc = 0; arc < coarse.target.size(); ++arc)
  {
    length += coarse.border_length[arc];
    if (coarse.curvature[arc] > 0 && coarse.curvature[arc] < largest_curvature)
      roots += coarse.border_length[arc] * std::sqrt(coarse.curvature[arc]);
  }
  return length > 0 ? CGAL::square(roots / length) : 0;
}

// What a valley says of a cut: little where the surface is full of as deep ones.
inline double weight_of_valleys(double roughness)
{
  constexpr double roughness_of_half = 1.25; // all but one of 193 Princeton models have less, brains have 2; decisions.md
  return 1 / (1 + CGAL::square(CGAL::square(roughness / roughness_of_half)));
}

// Measures all of a volume graph that a seam graph does not have, but the centres. `node` is the node of every face.
// Linear time.
inline void measure_volumes(const Indexed_surface& surface,
                            const std::vector<Indexed_surface::Index>& node,
                            const Index_groups& faces_of_nodes,
                            Volume_graph& graph,
                            bool is_parallel)
{
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;
  const double unit = unit_of_length(surface);
  const auto position = [unit](const Indexed_surface::Point_3& p) { return (p - Indexed_surface::Point_3(0, 0, 0)) / unit; };
  for (std::vector<Vector_3>* vectors : {&graph.border_area, &graph.border_vector, &graph.border_moment})
    vectors->assign(graph.target.size(), Vector_3(0, 0, 0));
  std::vector<double> lengths(graph.target.size(), 0);
  graph.area_vector.assign(graph.number_of_nodes(), Vector_3(0, 0, 0));
  graph.flux.assign(graph.number_of_nodes(), 0);
  const auto add_edge = [&](Index f, Index c, Index arc)
  {
    const Vector_3 a = position(surface.point(surface.vertex(c)));
    const Vector_3 b = position(surface.point(surface.vertex(surface.next_corner(f, c))));
    graph.border_area[arc] += cross_product(a, b) / 2;
    graph.border_vector[arc] += b - a;
    const double length = std::sqrt((b - a).squared_length());
    graph.border_moment[arc] += length * (a + b) / 2;
    lengths[arc] += length;
  };
  for_each_index(graph.number_of_nodes(), is_parallel,
                 [&](std::size_t i)
                 {
                   for (Index f : faces_of_nodes[i])
                   {
                     const Vector_3 area_vector = surface.area_vector(f) / (unit * unit);
                     graph.area_vector[i] += area_vector;
                     graph.flux[i] += area_vector * position(surface.centroid(f));
                     for_each_border_edge(surface, node, graph, f, [&](Index c, Index arc) { add_edge(f, c, arc); });
                   }
                   for (Index arc : graph.arcs(static_cast<Index>(i)))
                     if (lengths[arc] > 0) // straight borders are shorter than their edges
                       graph.border_moment[arc] = graph.border_moment[arc] * (graph.border_length[arc] / lengths[arc]);
                 });
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_MEASURE_COARSE_GRAPH_H
