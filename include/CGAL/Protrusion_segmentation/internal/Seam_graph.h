// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEAM_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEAM_GRAPH_H

#include <CGAL/Protrusion_segmentation/Surface_part.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A graph whose nodes are faces, or connected sets of faces, of a surface, with what segmentation by minimum
// cuts needs to know of them. Lengths are in units of the square root of the area of the whole surface,
// areas are shares of it, so that the result is independent of scale.
//
// The arcs of node i are first_arc[i] to first_arc[i + 1] - 1. Every arc has an opposite one with the same
// weights. Single precision halves the memory and is more than the input is worth.
struct Seam_graph
{
  using Index = Surface_part::Index;

  std::vector<Index> first_arc = std::vector<Index>(1, 0);
  std::vector<Index> target;
  std::vector<Index> opposite;

  std::vector<float> length;         // between the centres of the nodes
  std::vector<float> concave_length; // the same, lengthened where a concave seam lies between
  std::vector<float> curvature;      // mean along the border, positive where concave
  std::vector<float> border_length;  // of the edges that the two nodes share
  std::vector<float> concave_border; // the length of those of these edges that lie in a concave seam
  std::vector<float> capacity;       // the border length, cheap on concave seams: what a cut costs

  std::vector<double> area; // of the nodes
  std::vector<Surface_part::Point_3> centre;

  Index number_of_nodes() const { return static_cast<Index>(area.size()); }
  boost::integer_range<Index> arcs(Index node) const
  {
    return boost::irange(first_arc[node], first_arc[node + 1]);
  }
};

// Fills in the opposite arcs from the targets. Between two nodes there may be several arcs: the first one of
// one is opposite to the first one of the other, and so on.
inline void find_opposite_arcs(Seam_graph& graph)
{
  using Index = Seam_graph::Index;
  const Index n = graph.number_of_nodes();
  // visiting the arcs in the order of their targets meets the opposite arcs of each node in its own order
  std::vector<Index> arcs_into(n + 1, 0), by_target(graph.target.size());
  for (Index target : graph.target)
    ++arcs_into[target + 1];
  for (Index i = 0; i < n; ++i)
    arcs_into[i + 1] += arcs_into[i];
  for (Index arc = 0; arc < graph.target.size(); ++arc)
    by_target[arcs_into[graph.target[arc]]++] = arc;
  std::vector<Index> sorted(graph.target.size());
  std::iota(sorted.begin(), sorted.end(), Index(0));
  graph.opposite.resize(graph.target.size());
  for (Index i = 0; i < n; ++i)
  {
    // arcs out of i by target and arcs into i by source pair up one to one
    const auto begin = sorted.begin() + graph.first_arc[i];
    const auto end = sorted.begin() + graph.first_arc[i + 1];
    std::stable_sort(begin, end, [&](Index a, Index b) { return graph.target[a] < graph.target[b]; });
    for (auto arc = begin; arc != end; ++arc)
      graph.opposite[by_target[arc - sorted.begin()]] = *arc;
  }
}

// The length of an arc across a seam: distances from a tip grow there. The length added per radian of concave
// angle makes no difference between .15 and .4, except that the candidates get better.
inline float concave_length(double length, double curvature)
{
  constexpr double length_of_angle = 0.4;
  return static_cast<float>(length * (1 + length_of_angle * (std::max)(0., curvature)));
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEAM_GRAPH_H
