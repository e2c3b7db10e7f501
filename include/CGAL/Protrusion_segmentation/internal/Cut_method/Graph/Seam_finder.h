// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_SEAM_FINDER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_SEAM_FINDER_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Border_edges.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Border_roof.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Plate_rims.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Surface_average.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/average_normals.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Three times the signed volume of what closes a surface: each hole, a connected part of its border, gets a fan around its own
// centroid. A centre common to all holes would turn open surfaces inside out.
inline double signed_volume_of_holes(const Indexed_surface& surface, const Border_edges& border)
{
  using Index = Indexed_surface::Index;
  const Indexed_surface::Point_3 origin(0, 0, 0);
  const std::vector<Index> hole = border.parts(); // of every edge
  std::map<Index, std::pair<Indexed_surface::Vector_3, double>> moments; // of every hole, with its length
  for (std::size_t i = 0; i < hole.size(); ++i)
  {
    const Border_edges::Edge& edge = border()[i];
    auto& [moment, length] = moments.try_emplace(hole[i], Indexed_surface::Vector_3(0, 0, 0), 0.).first->second;
    moment += edge.length() * ((surface.point(edge.from) - origin) + (surface.point(edge.to) - origin)) / 2;
    length += edge.length();
  }
  double volume = 0;
  for (std::size_t i = 0; i < hole.size(); ++i)
  {
    const Border_edges::Edge& edge = border()[i];
    const auto& [moment, length] = moments.at(hole[i]);
    if (length > 0) // a triangle of the edge, turned over, and the centroid
      volume += cross_product(surface.point(edge.to) - origin, surface.point(edge.from) - origin) * (moment / length) / 2;
  }
  return volume;
}

// Three times the signed volume of a surface, closed where it has holes.
inline double signed_volume(const Indexed_surface& surface, const Border_edges& border, bool is_parallel)
{
  const Indexed_surface::Point_3 origin(0, 0, 0);
  return signed_volume_of_holes(surface, border) +
         add_numbers(surface.number_of_faces(), is_parallel, 0., [&](double& sum, Indexed_surface::Index f)
                     { sum += surface.area_vector(f) * (surface.centroid(f) - origin); });
}

// Finds the seams of a surface: an edge is concave if the averaged normals of its two faces lean towards each other, or if it lies
// in a valley of the roof over an open surface or a thin plate, or between two patches. The sign of the volume decides which
// side is inside.
class Seam_finder
{
public:
  using Index = Indexed_surface::Index;

  // The arguments must outlive the object.
  Seam_finder(const Indexed_surface& surface, const Cut_options& options, Execution& execution)
    : m_surface(surface), m_options(options), m_execution(execution)
  {}

  // `graph` has all of a dual graph, `centre` its centres.
  void operator()(Seam_graph& graph, const Centres& centre) const
  {
    const Border_edges border(m_surface);
    graph.outward = signed_volume(m_surface, border, m_execution.is_parallel()) < 0 ? -1 : 1;
    // with disks of a sixth of the radius borders on large meshes are less exact, and a plate of the tests has a part too many
    const Surface_average average(graph, centre, normal_radius / 9, m_execution), coarse_average(average, outline_radius / 7);
    const Padded_vectors normals = average_normals(m_surface, average, m_execution);
    const std::vector<bool> is_rim = Plate_rims(m_surface)(coarse_average);
    const Border_edges outline(m_surface, is_rim);
    Padded_vectors roof; // of a surface that is open or has rims
    if (!outline().empty())
      roof = Border_roof(m_surface, outline, m_execution)(normals, coarse_average);
    const auto has_roof = [&](Index f) { return !roof.empty() && (is_rim.empty() || !is_rim[f]); };
    graph.curvature.resize(graph.target.size());
    graph.capacity.resize(graph.target.size());
    graph.folded_length.resize(roof.empty() ? 0 : graph.target.size());
    for_each_number(graph.number_of_nodes(), m_execution.is_parallel(),
                    [&](Index f)
                    {
                      for (Index arc : graph.arcs(f))
                        weigh(graph, arc, curvature(graph, f, arc, normals),
                              has_roof(f) && has_roof(graph.target[arc]) ? valley(graph, f, arc, roof) : 0);
                    });
  }

private:
  static constexpr double largest_curvature = 60; // beyond it, a radius of 1/60, is tessellation

  // Between the normals of two faces, positive where these lean towards each other.
  double angle(Index f, Index g, const Padded_vectors& normals) const
  {
    const Indexed_surface::Vector_3 turn = unpadded(normals[g] - normals[f]);
    // by the chord: the cosine of a small angle is inaccurate
    const double size = 2 * std::asin((std::min)(1., std::sqrt(turn.squared_length()) / 2));
    return turn * (m_surface.centroid(g) - m_surface.centroid(f)) < 0 ? size : -size;
  }

  // Of an arc, positive where concave. Where two patches meet there is a seam, and less of one inside a patch.
  double curvature(const Seam_graph& graph, Index f, Index arc, const Padded_vectors& normals) const
  {
    constexpr double curvature_between_patches = 15, share_in_patch = 0.5; // decisions.md, "Contacts"
    const Index g = graph.target[arc];
    const double angle = graph.outward * this->angle(f, g, normals);
    const double strength = (std::min)(largest_curvature, std::abs(angle) / graph.length[arc]);
    const double curvature = angle > 0 ? strength : -strength;
    if (!m_surface.has_patches())
      return curvature;
    return m_surface.patch(f) == m_surface.patch(g) ? share_in_patch * curvature
                                                    : (std::max)(curvature, curvature_between_patches);
  }

  // The curvature of the roof across an arc where it falls from both faces towards each other, else 0: its ridges would hide folds of
  // the surface beside the ends of pipes.
  double valley(const Seam_graph& graph, Index f, Index arc, const Padded_vectors& roof) const
  {
    const Index g = graph.target[arc];
    const Indexed_surface::Vector_3 turn = unpadded(roof[f] - roof[g]), step = m_surface.centroid(g) - m_surface.centroid(f);
    const double length = std::sqrt(step.squared_length());
    const double curvature = length > 0 ? turn * step / length / graph.length[arc] : 0;
    return (std::max)(0., (std::min)(largest_curvature, curvature));
  }

  // `fold`: the curvature of the surface; `valley`: that of its roof
  void weigh(Seam_graph& graph, Index arc, double fold, double valley) const
  {
    const double curvature = fold + valley;
    if (!graph.folded_length.empty())
      graph.folded_length[arc] = fold > (std::max)(Seam_graph::seam_curvature, valley) ? graph.border_length[arc] : 0;
    graph.curvature[arc] = static_cast<float>(curvature);
    graph.capacity[arc] = static_cast<float>(m_options.cost(graph.border_length[arc], curvature));
  }

  const Indexed_surface& m_surface;
  const Cut_options& m_options;
  Execution& m_execution;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_SEAM_FINDER_H
