// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CLUES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CLUES_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// What of a cut tells whether people would cut there. All clues are independent of scale.
struct Cut_clues
{
  double concave_share;    // of the cut's length, the share in a concave seam
  double relative_length;  // log of the length relative to the square root of the smaller area
  double segment_size;     // log of the segment's share of the area of the component
  double larger_widening;  // log of the area of a strip beside the cut relative to that of a straight one,
  double smaller_widening; // of the two sides
  double larger_shoulder;  // how fast the opening grows in such a strip, relative to the area of the strip: 1 in a wall that
  double smaller_shoulder; // a rod sticks out of, 0 along the rod, -1 where it ends; of the two sides
  double roundness;        // log of the area of the opening relative to that of a circle as long as the cut
  double neighbors;        // log of the length of earlier borders around the smaller side relative to the cut's
  double contrast;         // log of what a cut beside this one costs relative to it, of the dearer side
  double mean_cost;        // log of the cost of a unit of length
  double thickness;        // log of the volume of the smaller side relative to its area and opening
  double inner_concavity;  // the length of concave seams inside the smaller side
  double several_loops;    // 1 if the cut consists of several loops, else 0
  double flatness;         // of the area of the smaller side, the share that faces one way and not the other: 1 of a piece of a
                           // plane, 1/2 of a half sphere, near 0 of a limb; 0 where the whole is a flat sheet
};

// Computes the clues of the cut whose inner side, marked, is `inner`, out of a segment of a coarse graph.
class Clues_of_cut
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = Graph_partition::Nodes;
  using Vector_3 = Indexed_surface::Vector_3;

  Clues_of_cut(Graph_partition& partition, Index segment, const Nodes& nodes, const Nodes& inner, double segment_area)
    : m_partition(partition),
      m_graph(partition.graph()),
      m_segment(segment),
      m_inner_area(partition.area(inner)),
      m_segment_area(segment_area),
      m_inner_is_smaller(2 * m_inner_area <= segment_area),
      m_size(std::sqrt((std::min)(m_inner_area, segment_area - m_inner_area)))
  {
    measure_cut(inner);
    std::tie(m_inside, m_outside) = partition.nodes_along_cut(segment, inner);
    measure_smaller_side(nodes);
  }

  Cut_clues operator()()
  {
    const Side inside = measure_side(m_inside, true), outside = measure_side(m_outside, false);
    Cut_clues clues;
    clues.concave_share = m_concave_length / m_length;
    clues.relative_length = std::log(length_around() / m_size);
    clues.segment_size = std::log(m_segment_area);
    clues.larger_widening = (std::max)(inside.widening, outside.widening);
    clues.smaller_widening = (std::min)(inside.widening, outside.widening);
    clues.larger_shoulder = (std::max)(inside.shoulder, outside.shoulder);
    clues.smaller_shoulder = (std::min)(inside.shoulder, outside.shoulder);
    clues.roundness = std::log(4 * CGAL_PI * opening() / CGAL::square(length_around()) + 0.05);
    clues.neighbors = std::log(1 + m_earlier_length / m_length);
    clues.contrast = (std::max)(inside.contrast, outside.contrast);
    clues.mean_cost = std::log(m_cost / m_length + 0.02);
    clues.thickness = std::log((std::max)(0.001, 4 * volume() / (smaller_area() * std::sqrt(opening() + 0.02 * smaller_area()))));
    clues.inner_concavity = m_inner_concave_length / m_size;
    clues.several_loops = has_several_loops() ? 1 : 0;
    clues.flatness = m_graph.is_flat ? 0 : std::sqrt(m_area_vector.squared_length()) / smaller_area();
    return clues;
  }

private:
  struct Side
  {
    double widening, shoulder, contrast;
  };

  double smaller_area() const { return CGAL::square(m_size); }

  // A flat sheet is measured as one half of a round body, of which a cut has a circular opening and cuts off a cylinder.
  // In units of the root of the area of both halves, it is longer by the root of two.
  double length_around() const { return m_graph.is_flat ? std::sqrt(2.) * m_length : m_length; }
  // the area of the opening that the cut leaves
  double opening() const
  {
    return m_graph.is_flat ? CGAL::square(length_around()) / (4 * CGAL_PI) : std::sqrt(m_opening.squared_length());
  }

  void measure_cut(const Nodes& inner)
  {
    constexpr double least_length = 1e-9;
    Vector_3 moment(0, 0, 0), ends(0, 0, 0);
    m_partition.for_each_arc_of_cut(m_segment, inner, [&](Index arc, Index, Index)
                                    {
                                      m_concave_length += m_graph.concave_border(arc);
                                      m_length += m_graph.border_length[arc];
                                      m_cost += m_graph.capacity[arc];
                                      m_opening += m_graph.border_area[arc];
                                      ends += m_graph.border_vector[arc];
                                      moment += m_graph.border_moment[arc];
                                    });
    m_length = (std::max)(m_length, least_length);
    m_cost = (std::max)(m_cost, least_length);
    m_centre = moment / m_length;
    m_opening -= cross_product(m_centre, ends) / 2; // a cone over the cut, also if this ends at the border of the surface
  }

  void measure_smaller_side(const Nodes& nodes)
  {
    for (Index i : nodes)
    {
      if (m_partition.is_inner(i) != m_inner_is_smaller)
        continue;
      m_area_vector += m_graph.area_vector[i];
      m_flux += m_graph.flux[i];
      for (Index arc : m_graph.arcs(i))
      {
        const Index j = m_graph.target[arc];
        if (m_partition.segment(j) != m_segment)
          m_earlier_length += m_graph.border_length[arc];
        else if (m_partition.is_inner(j) == m_inner_is_smaller)
          m_inner_concave_length += m_graph.concave_border(arc) / 2; // seen from both ends
      }
    }
  }

  // of the smaller side, closed by a cone over the cut
  double volume() const
  {
    return m_graph.is_flat ? smaller_area() * length_around() / (4 * CGAL_PI)
                           : std::abs(m_flux - m_area_vector * m_centre) / 3;
  }

  // How much of a node lies in a strip that reaches `depth` beyond its centre. A strip is few nodes wide: if they
  // were in it as a whole or not at all, what it measures would be a matter of chance.
  static float share_of_strip(double depth, double area)
  {
    return static_cast<float>((std::min)(1., (std::max)(0., depth / std::sqrt(area) + 0.5)));
  }

  // The strip along the cut on one side: where the surface widens it is larger than its length and width say, the
  // sudden widening that the paper looks for in its histograms. And what a cut along its far edge would cost.
  Side measure_side(const Nodes& along_cut, bool inner)
  {
    constexpr double strip_width = 0.4; // relative to the square root of the smaller area
    constexpr double least_widening = 1e-6;
    const double width = strip_width * m_size;
    const Nodes_by_distance near =
      m_partition.nodes_by_distance_on_side(along_cut, m_segment, inner, m_graph.lengths(),
                                            width + m_partition.largest_size() / 2);
    std::vector<float> shares;
    double area = 0;
    Vector_3 area_vector(0, 0, 0);
    for (std::size_t i = 0; i < near.nodes.size(); ++i)
    {
      const double node_area = m_graph.area[near.nodes[i]];
      shares.push_back(share_of_strip(width - near.distances[i], node_area));
      area += shares.back() * node_area;
      area_vector += double(shares.back()) * m_graph.area_vector[near.nodes[i]];
    }
    const double widening = (std::max)(least_widening, area / (m_length * width));
    const double far_cost = m_partition.cost_around(near.nodes, shares, m_segment, inner);
    return {std::log(widening),
            m_graph.is_flat ? flat_shoulder(widening, width) : shoulder(area_vector, area, inner),
            std::log((far_cost + 0.1 * m_cost) / m_cost)};
  }

  // The opening grows by what the faces of the strip show along the axis of the cut, away from the other side. What
  // sticks out across the axis, as a leg out of a trunk, shows as much forwards as backwards, and does not count.
  double shoulder(const Vector_3& area_vector, double area, bool inner) const
  {
    const double size = std::sqrt(m_opening.squared_length()) * area;
    if (size == 0)
      return 0;
    return (inner ? -1 : 1) * (m_opening * area_vector) / size;
  }

  // The far edge of a flat strip of that area is as wide as if its sides were straight. Both halves of the round body count.
  double flat_shoulder(double widening, double width) const
  {
    const double far_width = (std::max)(0., 2 * widening - 1);
    const double growth = m_length * (CGAL::square(far_width) - 1) / CGAL_PI;
    return (std::min)(1., (std::max)(-1., growth / (2 * width * widening)));
  }

  bool has_several_loops()
  {
    Nodes along_cut = m_inside;
    along_cut.insert(along_cut.end(), m_outside.begin(), m_outside.end());
    return !m_partition.are_connected(along_cut);
  }

  Graph_partition& m_partition;
  const Weighted_dual_graph& m_graph;
  Index m_segment;
  double m_inner_area, m_segment_area;
  bool m_inner_is_smaller;
  double m_size; // square root of the smaller area
  Nodes m_inside, m_outside;
  double m_concave_length = 0, m_length = 0, m_cost = 0;                // of the cut
  Vector_3 m_opening{0, 0, 0}, m_centre{0, 0, 0};                       // of the cut
  double m_earlier_length = 0, m_inner_concave_length = 0, m_flux = 0; // of the smaller side
  Vector_3 m_area_vector{0, 0, 0};                                      // of the smaller side
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CLUES_H
