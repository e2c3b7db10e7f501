// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_TIP_ORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_TIP_ORDERS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The nodes of a segment by their distances from protrusion tips, on the graph itself: what the default method
// measures. Arcs across concave seams are longer there than on the surface.
class Tip_orders
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = Graph_partition::Nodes;

  Tip_orders(Graph_partition& partition, Execution& execution)
    : m_partition(partition), m_execution(execution), m_to_nearest_tip(partition.graph().number_of_nodes())
  {}

  Nodes_by_distance from_tip(Index segment, Index tip)
  {
    m_execution.check();
    ++m_number_of_runs;
    return m_partition.nodes_by_distance(
      Nodes(1, tip), [&](Index i) { return m_partition.segment(i) == segment; },
      m_partition.graph().seam_lengths());
  }

  // Calls `visit(order)` with the order from each of the tips of a segment with the given nodes. These are selected by eq. (2)
  // from the node farthest from the segment's centre of gravity on until the segment is covered.
  template <typename Visit>
  void from_all_tips(Index segment, const Nodes& nodes, Visit visit)
  {
    constexpr std::size_t maximum_number_of_tips = 12;
    // a tip nearer to another one than that share of the segment's size is no tip of its own
    constexpr double least_distance = 0.1;
    const double size = std::sqrt(m_partition.area(nodes));
    for (Index i : nodes)
      m_to_nearest_tip[i] = (std::numeric_limits<double>::infinity)();
    Index tip = from_tip(segment, central_node(nodes)).nodes.back();
    for (std::size_t number = 0; number < maximum_number_of_tips; ++number)
    {
      Nodes_by_distance order = from_tip(segment, tip);
      for (std::size_t i = 0; i < order.nodes.size(); ++i)
        m_to_nearest_tip[order.nodes[i]] = (std::min)(m_to_nearest_tip[order.nodes[i]], order.distances[i]);
      visit(std::move(order.nodes));
      tip = *std::max_element(nodes.begin(), nodes.end(), [&](Index a, Index b)
                              { return m_to_nearest_tip[a] < m_to_nearest_tip[b]; });
      if (m_to_nearest_tip[tip] < least_distance * size)
        return;
    }
  }

  std::size_t number_of_runs() const { return m_number_of_runs; }

private:
  // The node nearest to the centre of gravity.
  Index central_node(const Nodes& nodes) const
  {
    const Weighted_dual_graph& graph = m_partition.graph();
    const Indexed_surface::Point_3 origin(0, 0, 0);
    const double area = m_partition.area(nodes);
    Indexed_surface::Vector_3 moment(0, 0, 0);
    for (Index i : nodes)
      moment += graph.area[i] * (graph.centre_of(i) - origin);
    const Indexed_surface::Point_3 centre = area > 0 ? origin + moment / area : origin;
    return *std::min_element(nodes.begin(), nodes.end(),
                             [&](Index a, Index b)
                             {
                               return squared_distance(graph.centre_of(a), centre) <
                                      squared_distance(graph.centre_of(b), centre);
                             });
  }

  Graph_partition& m_partition;
  Execution& m_execution;
  std::vector<double> m_to_nearest_tip;
  std::size_t m_number_of_runs = 0;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_TIP_ORDERS_H
