// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_BORDER_ROOF_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_BORDER_ROOF_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/diffusion.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Calls `visit(f, c)` for the faces f and their corners c from which an edge of the border goes.
template <typename Visit>
void for_each_border_corner(const Indexed_surface& surface, Visit visit)
{
  for (Indexed_surface::Index f = 0; f < surface.number_of_faces(); ++f)
    for (Indexed_surface::Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      if (surface.neighbor(c) == Indexed_surface::no_face())
        visit(f, c);
}

// Whether the surface has a border.
inline bool is_open(const Indexed_surface& surface)
{
  bool result = false;
  for_each_border_corner(surface, [&](Indexed_surface::Index, Indexed_surface::Index) { result = true; });
  return result;
}

// The edges of the border of a surface.
class Border_edges
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  struct Edge
  {
    Index face, from, to; // the latter are vertices
    Vector_3 vector;
  };

  explicit Border_edges(const Indexed_surface& surface)
    : m_edge_from(surface.number_of_vertices(), none), m_edge_to(surface.number_of_vertices(), none)
  {
    for_each_border_corner(surface, [&](Index f, Index c)
                           {
                             const Index from = surface.vertex(c), to = surface.vertex(surface.next_corner(f, c));
                             m_edge_from[from] = m_edge_to[to] = static_cast<Index>(m_edges.size());
                             m_edges.push_back({f, from, to, surface.point(to) - surface.point(from)});
                           });
  }

  const std::vector<Edge>& operator()() const { return m_edges; }

  // The chord of the border from `reach` before to `reach` after the middle of an edge, scaled to the length of the edge.
  Vector_3 straight(std::size_t edge, double reach) const
  {
    const Vector_3 own = m_edges[edge].vector;
    const double length = std::sqrt(own.squared_length());
    Vector_3 chord = own;
    for (bool is_forward : {false, true})
    {
      double rest = reach - length / 2;
      for (Index e = next(edge, is_forward); e != none && e != edge && rest > 0; e = next(e, is_forward))
      {
        const double step = (std::max)(std::sqrt(m_edges[e].vector.squared_length()), least_step * reach);
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
  std::vector<Index> m_edge_from, m_edge_to; // of every vertex of the border
};

// A roof over an open surface that falls towards the border. Of a sheet only the outline shows what sticks out, of a scan from
// one side much of it: at a concave corner of the border the roof has a valley, which is a seam from there into the sheet.
class Border_roof
{
public:
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;

  Border_roof(const Indexed_surface& surface, Execution& execution) : m_surface(surface), m_execution(execution) {}

  // For each face the direction in which the roof falls, along the surface, as long as its slope. `graph` is the dual graph of
  // the surface, `centre` its centres, `normals` its averaged normals
  Triples operator()(const Dual_graph& graph, const Centres& centre, const Triples& normals) const
  {
    Triples directions = directions_at_border(normals);
    Multilevel_diffusion(radius, m_execution)(graph, centre, directions);
    for (std::size_t f = 0; f < normals.size(); ++f)
    {
      const Vector_3 normal = vector(normals[f]), direction = vector(directions[f]);
      const Vector_3 tangential = direction - (direction * normal) * normal; // it may have come around an edge
      directions[f] = triple(steepness / (std::max)(1., std::sqrt(tangential.squared_length())) * tangential);
    }
    return directions;
  }

private:
  static Vector_3 vector(const Triple& t) { return {t[0], t[1], t[2]}; }

  // Over which directions at the border are averaged, in units of the square root of the area. With .2 terrain is cut, with .1
  // arms are cut in two.
  static constexpr double radius = 0.15;

  // A border that is shorter, in units of the square root of the area, is that of a hole or of a limb's end and has no roof: it
  // says nothing of the outline.
  static constexpr double longest_hole = 0.4;

  // How far to both sides the border is seen as straight, in units of the square root of the area: the zigzag of triangles along it
  // has no corners. With .02 fewer random shapes are right, with .05 fewer stars.
  static constexpr double straight_length = 0.03;

  // The slope of the roof where directions have at least length 1, which is near the border. From 1.75 to 2.5 there is little
  // difference.
  static constexpr double steepness = 2;

  // For each vertex, the length of the part of the border that it lies on, 0 if on none.
  std::vector<double> lengths_of_borders() const
  {
    Disjoint_sets parts(m_surface.number_of_vertices());
    for_each_border_corner(m_surface, [&](Index f, Index c)
                           { parts.union_set(m_surface.vertex(c), m_surface.vertex(m_surface.next_corner(f, c))); });
    std::vector<double> lengths(m_surface.number_of_vertices(), 0);
    for_each_border_corner(m_surface, [&](Index f, Index c) { lengths[parts.find_set(m_surface.vertex(c))] += m_surface.edge_length(f, c); });
    for (Index v = 0; v < lengths.size(); ++v)
      lengths[v] = lengths[parts.find_set(v)];
    return lengths;
  }

  // Outwards in the faces at the border. After diffusion over the radius a straight border has directions of length 4.
  Triples directions_at_border(const Triples& normals) const
  {
    const double unit = unit_of_length(m_surface);
    const std::vector<double> lengths = lengths_of_borders();
    const Border_edges edges(m_surface);
    std::vector<Vector_3> borders(edges().size(), Vector_3(0, 0, 0));
    for_each_number(borders.size(), m_execution.is_parallel(),
                    [&](std::size_t i)
                    {
                      if (lengths[edges()[i].from] >= longest_hole * unit)
                        borders[i] = edges.straight(i, straight_length * unit);
                    });
    Triples result(m_surface.number_of_faces(), {0, 0, 0});
    for (std::size_t i = 0; i < borders.size(); ++i)
      if (const Index f = edges()[i].face; m_surface.area(f) > 0)
      {
        const Vector_3 outwards = cross_product(borders[i], vector(normals[f])) * (2 * radius * unit / m_surface.area(f));
        result[f] = triple(vector(result[f]) + outwards);
      }
    return result;
  }

  const Indexed_surface& m_surface;
  Execution& m_execution;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_BORDER_ROOF_H
