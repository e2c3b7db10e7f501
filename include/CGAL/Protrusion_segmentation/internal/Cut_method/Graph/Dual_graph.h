// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DUAL_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DUAL_GRAPH_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A graph whose nodes are faces, or connected sets of faces, of a connected surface. Lengths are in units of the square
// root of the area of the whole surface, areas are shares of it, so that results are independent of scale.
//
// The arcs of node i are first_arc[i] to first_arc[i + 1] - 1. For every arc there is one back with the same weights, up to
// rounding. Single precision halves the memory and is more than the input is worth.
struct Dual_graph
{
  using Index = Indexed_surface::Index;

  std::vector<Index> first_arc = std::vector<Index>(1, 0);
  std::vector<Index> target;        // of every arc
  std::vector<float> length;        // of every arc, between the centres of the nodes
  std::vector<float> border_length; // of every arc, of the edges that the two nodes share
  std::vector<double> area;         // of every node

  Index number_of_nodes() const { return static_cast<Index>(area.size()); }
  boost::integer_range<Index> arcs(Index node) const { return boost::irange(first_arc[node], first_arc[node + 1]); }
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
  // as a function of an arc, which must not outlive the graph
  auto lengths() const
  {
    return [this](Index arc) { return length[arc]; };
  }
  // longer across seams where these are known
  float seam_length(Index arc) const { return length[arc]; }
};

// That of a graph: the square root of the area of the surface.
inline double unit_of_length(const Indexed_surface& surface)
{
  return surface.area() > 0 ? std::sqrt(surface.area()) : 1;
}

// The centres of the nodes of a graph, in its unit of length, around the centre of the surface.
using Centres = std::vector<Simple_cartesian<float>::Point_3>;

inline Indexed_surface::Point_3 point(const Simple_cartesian<float>::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}
inline Simple_cartesian<float>::Point_3 centre(const Indexed_surface::Point_3& p)
{
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

// A dual graph with its seams: what minimum cuts need.
struct Seam_graph : Dual_graph
{
  static constexpr double seam_curvature = 2; // from which on an edge lies in a seam: a radius of 1/2

  std::vector<float> curvature;      // of every arc, the mean along the border, positive where concave
  std::vector<float> concave_length; // see `length_in_seam()`
  std::vector<float> folded_length;  // see `length_in_fold()`
  std::vector<float> capacity;       // of every arc, the border length, cheap on seams: the cost of a cut
  double outward = 1;                // the side that the faces' normals point to: 1 out of the body, -1 into it

  // Of an arc, the length of the border's edges that lie in a concave seam. Between two faces an edge does or does not, and
  // nothing is kept.
  float length_in_seam(Index arc) const
  {
    if (!concave_length.empty())
      return concave_length[arc];
    return curvature[arc] > seam_curvature ? border_length[arc] : 0;
  }
  // That of the edges where the surface itself makes the seam, not its roof. Nothing is kept without a roof.
  float length_in_fold(Index arc) const { return folded_length.empty() ? length_in_seam(arc) : folded_length[arc]; }

  // The length of an arc, longer across a concave seam: distances from a tip grow there.
  float seam_length(Index arc) const
  {
    // by one radian of concave angle; between .15 and .4 results are the same, but candidates get better
    constexpr double length_of_angle = 0.4;
    return static_cast<float>(length[arc] * (1 + length_of_angle * (std::max)(0.f, curvature[arc])));
  }
  auto seam_lengths() const
  {
    return [this](Index arc) { return seam_length(arc); };
  }
};

// A seam graph with what the openings of cuts and the volumes of their sides are computed from, see `measure_volumes()`.
struct Volume_graph : Seam_graph
{
  using Vector_3 = Indexed_surface::Vector_3;

  // Of every arc, summed over the edges AB of its border in the orientation of its source: A x B / 2, B - A, and the
  // midpoint times the length.
  std::vector<Vector_3> border_area, border_vector, border_moment;
  std::vector<Vector_3> area_vector; // of every node, the sum of those of its faces,
  std::vector<double> flux;          // and of their products with the faces' centroids
  Centres centre;                    // of every node
  double weight_of_valleys = 1;      // what a concave border says of a cut, see `weight_of_valleys()`
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DUAL_GRAPH_H
