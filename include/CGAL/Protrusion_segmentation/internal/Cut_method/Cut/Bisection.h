// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_BISECTION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_BISECTION_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A segment, divided in two by a cut. After each call the list of the nodes of the inner side, which has at most half of the area, and
// their marks in a partition agree.
class Bisection
{
public:
  using Index = Dual_graph::Index;

  // The arguments must outlive the object. All nodes are outer ones.
  Bisection(Graph_partition& partition, const Segment& segment) : m_partition(partition), m_segment(segment)
  {
    partition.select(segment);
  }

  Graph_partition& partition() const { return m_partition; }
  const Seam_graph& graph() const { return m_partition.graph(); }
  const Segment& segment() const { return m_segment; }
  const Nodes& inner() const { return m_inner; } // ascending
  double inner_area() const { return m_inner_area; }
  bool has_large_sides() const { return is_large_enough(m_inner_area, m_segment.area); }

  // Makes these nodes the inner side, or their complement if that is smaller, and both sides connected.
  void set_side(const Nodes& side)
  {
    take_smaller(m_partition.connect_sides(m_segment.nodes, side));
  }
  // The same if both sides are connected. The nodes are ascending.
  void set_connected_side(Nodes side)
  {
    m_partition.mark(m_segment.nodes, side);
    take_smaller(std::move(side));
  }

  double relative_cost() const
  {
    double cost = 0;
    m_partition.for_each_arc_of_cut(m_inner, [&](Index arc, Index, Index) { cost += graph().capacity[arc]; });
    return internal::relative_cost(cost, m_inner_area, m_segment.area);
  }

private:
  void take_smaller(Nodes side)
  {
    m_inner = std::move(side);
    m_inner_area = graph().area_of(m_inner);
    if (2 * m_inner_area <= m_segment.area)
      return;
    m_inner = other_side(m_segment, m_inner);
    m_inner_area = graph().area_of(m_inner);
    m_partition.mark(m_segment.nodes, m_inner);
  }

  Graph_partition& m_partition;
  const Segment& m_segment;
  Nodes m_inner;
  double m_inner_area = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_BISECTION_H
