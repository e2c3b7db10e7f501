// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_TIP_ORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_TIP_ORDERS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The nodes of a segment by their distances from protrusion tips, on the coarse graph itself: the default distance. Arcs across
// concave seams are longer there than on the surface.
class Tip_orders
{
public:
  using Index = Dual_graph::Index;

  // The arguments must outlive the object.
  Tip_orders(const Volume_graph& graph, Graph_partition& partition, Graph_distances& distances)
    : m_graph(graph), m_partition(partition), m_distances(distances), m_to_nearest_tip(graph.number_of_nodes())
  {}

  Nodes_by_distance from_tip(const Segment& segment, Index tip)
  {
    m_partition.select(segment);
    return m_distances(
      Nodes(1, tip), [&](Index, Index to) { return m_partition.is_selected(to); }, m_distances.seam_lengths());
  }

  // The orders from the tips of a segment, selected by eq. (2) of the paper from the node farthest from the segment's centre of
  // gravity on until the segment is covered.
  std::vector<Nodes> operator()(const Segment& segment, Execution& execution)
  {
    constexpr std::size_t maximum_number_of_tips = 9;
    constexpr double least_distance = 0.1; // between tips, as a share of the segment's size
    const double size = std::sqrt(segment.area);
    for (Index i : segment.nodes)
      m_to_nearest_tip[i] = (std::numeric_limits<double>::infinity)();
    std::vector<Nodes> orders;
    Index tip = from_tip(segment, central_node(segment)).nodes.back();
    while (orders.size() < maximum_number_of_tips)
    {
      execution.check();
      Nodes_by_distance order = from_tip(segment, tip);
      for (std::size_t i = 0; i < order.nodes.size(); ++i)
        m_to_nearest_tip[order.nodes[i]] = (std::min)(m_to_nearest_tip[order.nodes[i]], order.distances[i]);
      orders.push_back(std::move(order.nodes));
      tip = *std::max_element(segment.nodes.begin(), segment.nodes.end(),
                              [&](Index a, Index b) { return m_to_nearest_tip[a] < m_to_nearest_tip[b]; });
      if (m_to_nearest_tip[tip] < least_distance * size)
        break;
    }
    return orders;
  }

private:
  // The node nearest to the centre of gravity.
  Index central_node(const Segment& segment) const
  {
    const Indexed_surface::Point_3 origin(0, 0, 0);
    Indexed_surface::Vector_3 moment(0, 0, 0);
    for (Index i : segment.nodes)
      moment += m_graph.area[i] * (point(m_graph.centre[i]) - origin);
    const Indexed_surface::Point_3 middle = segment.area > 0 ? origin + moment / segment.area : origin;
    const auto to_middle = [&](Index i) { return squared_distance(point(m_graph.centre[i]), middle); };
    return *std::min_element(segment.nodes.begin(), segment.nodes.end(),
                             [&](Index a, Index b) { return to_middle(a) < to_middle(b); });
  }

  const Volume_graph& m_graph;
  Graph_partition& m_partition;
  Graph_distances& m_distances;
  std::vector<double> m_to_nearest_tip; // of every node
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_TIP_ORDERS_H
