// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_WEIGHTED_DUAL_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_WEIGHTED_DUAL_GRAPH_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A graph whose nodes are faces, or connected sets of faces, of a surface, with what segmentation by minimum
// cuts needs to know of them. Lengths are in units of the square root of the area of the whole surface,
// areas are shares of it, so that the result is independent of scale.
//
// The arcs of node i are first_arc[i] to first_arc[i + 1] - 1. For every arc there is one back with the
// same weights. Single precision halves the memory and is more than the input is worth.
struct Weighted_dual_graph
{
  using Index = Indexed_surface::Index;

  std::vector<Index> first_arc = std::vector<Index>(1, 0);
  std::vector<Index> target;

  std::vector<float> length;                // between the centres of the nodes
  std::vector<float> curvature;             // mean along the border, positive where concave
  std::vector<float> border_length;         // of the edges that the two nodes share
  std::vector<float> concave_border_length; // of a coarse graph, see `concave_border()`
  std::vector<float> kept_seam_length;      // of a coarse graph, see `keep_seam_lengths()`
  std::vector<float> capacity;              // the border length, cheap on concave seams: what a cut costs

  std::vector<double> area; // of the nodes

  // Of a coarse graph only, see `measure_volumes()`. Of every arc, summed over the edges AB of its border in the
  // orientation of its source: A x B / 2 and B - A, from which the area of an opening comes, and the midpoint
  // times the length. Of every node the sum of its area vectors, and of their products with the centroids.
  std::vector<Indexed_surface::Vector_3> border_area, border_vector, border_moment, area_vector;
  std::vector<double> flux;
  std::vector<Simple_cartesian<float>::Point_3> centre;

  double length_of_angle = 0; // by how much one radian of concave angle lengthens an arc
  bool is_flat = false;       // a sheet cut out of a plane

  Index number_of_nodes() const { return static_cast<Index>(area.size()); }
  boost::integer_range<Index> arcs(Index node) const
  {
    return boost::irange(first_arc[node], first_arc[node + 1]);
  }
  double area_of(const std::vector<Index>& nodes) const
  {
    double sum = 0;
    for (Index i : nodes)
      sum += area[i];
    return sum;
  }
  // the arc between two neighbouring nodes
  Index arc_between(Index from, Index to) const
  {
    const auto candidates = arcs(from);
    return *std::find_if(candidates.begin(), candidates.end(), [&](Index arc) { return target[arc] == to; });
  }
  // The length of those edges of a border that lie in a concave seam. Between two faces that is all or nothing.
  float concave_border(Index arc) const
  {
    // concave curvature from which on an edge lies in a seam, a radius of 1/2: on a plateau, chosen on half of the
    // development models of the Princeton benchmark
    constexpr float seam_curvature = 2;
    if (!concave_border_length.empty())
      return concave_border_length[arc];
    return curvature[arc] > seam_curvature ? border_length[arc] : 0;
  }
  // The length of an arc, lengthened where it crosses a concave seam: distances from a tip grow there.
  float seam_length(Index arc) const
  {
    if (!kept_seam_length.empty())
      return kept_seam_length[arc];
    return static_cast<float>(length[arc] * (1 + length_of_angle * (std::max)(0.f, curvature[arc])));
  }
  // Where they are asked for again and again. No length may change afterwards.
  void keep_seam_lengths()
  {
    std::vector<float> lengths;
    lengths.reserve(target.size());
    for (Index arc = 0; arc < target.size(); ++arc)
      lengths.push_back(seam_length(arc));
    kept_seam_length = std::move(lengths);
  }
  // the two as functions of an arc, which must not outlive the graph
  auto lengths() const
  {
    return [this](Index arc) { return length[arc]; };
  }
  auto seam_lengths() const
  {
    return [this](Index arc) { return seam_length(arc); };
  }
  Indexed_surface::Point_3 centre_of(Index node) const
  {
    return {centre[node].x(), centre[node].y(), centre[node].z()};
  }
  void set_centre(Index node, const Indexed_surface::Point_3& p)
  {
    centre[node] = Simple_cartesian<float>::Point_3(static_cast<float>(p.x()), static_cast<float>(p.y()),
                                                    static_cast<float>(p.z()));
  }
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_WEIGHTED_DUAL_GRAPH_H
