// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_LEVEL_SET_CUTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_LEVEL_SET_CUTS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A side of a cut with a smaller share of the surface is a detail of the mesh and no segment of the shape.
constexpr double least_area_of_segment = 0.0025;

inline bool is_large_enough(double area, double segment_area)
{
  return (std::min)(area, segment_area - area) >= least_area_of_segment;
}

// The cost of a cut relative to an area. The exponent lies between the relative length of a loop on a surface, 1/2,
// which finds the smallest necks, and the ratio cut, 1, which finds halves: 3/4.
inline double cost_for_area(double cost, double area)
{
  return cost / (std::sqrt(area) * std::sqrt(std::sqrt(area)));
}

// The same for the area of the smaller side.
inline double relative_cost(double cost, double area, double segment_area)
{
  return is_large_enough(area, segment_area) ? cost_for_area(cost, (std::min)(area, segment_area - area))
                                             : (std::numeric_limits<double>::infinity)();
}

// A component of a level set: the nodes connected to `node` over nodes not after it in an order of the
// segment's nodes, or not before it if `descending`.
struct Level_set
{
  double relative_cost;
  Weighted_dual_graph::Index node;
  std::size_t order; // its number
  bool descending;
};

// Finds, among all components of all sublevel sets of an order of nodes, the best one in each branch of their merge
// tree. One union-find sweep with the area and the cost of the cut around each component, nearly linear.
class Level_set_sweep
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = Graph_partition::Nodes;

  explicit Level_set_sweep(const Graph_partition& partition)
    : m_partition(partition),
      m_rank(partition.graph().number_of_nodes(), 0),
      m_sets(partition.graph().number_of_nodes()),
      m_components(partition.graph().number_of_nodes())
  {}

  // `order` holds the nodes of one segment, lowest first; the best sets are added to `level_sets`.
  void operator()(const Nodes& order,
                  double segment_area,
                  std::size_t number_of_order,
                  bool descending,
                  std::vector<Level_set>& level_sets)
  {
    const auto add = [&](const Component& component)
    {
      if (component.best < (std::numeric_limits<double>::infinity)())
        level_sets.push_back({component.best, component.best_node, number_of_order, descending});
    };
    for (std::size_t i = 0; i < order.size(); ++i)
      m_rank[order[i]] = static_cast<Index>(i);
    for (Index node : order)
    {
      const Index root = absorb(node, add);
      Component& component = m_components[root];
      const double cost = relative_cost(component.cost, component.area, segment_area);
      if (cost < component.best)
      {
        component.best = cost;
        component.best_node = node;
      }
    }
    if (!order.empty())
      add(m_components[m_sets.find_set(order.back())]);
  }

private:
  struct Component
  {
    double area;
    double cost;
    double best; // least relative cost since the last merger of two components
    Index best_node;

    void forget_best() { best = (std::numeric_limits<double>::infinity)(); }
  };

  // Adds `node` to the components that it touches, merging them; returns what stands for the result.
  template <typename Add>
  Index absorb(Index node, Add add)
  {
    const Weighted_dual_graph& graph = m_partition.graph();
    m_sets.make_set(node);
    m_components[node] = {graph.area[node], 0, 0, node};
    m_components[node].forget_best();
    Index root = node;
    double cost = 0;
    for (Index arc : graph.arcs(node))
    {
      const Index neighbor = graph.target[arc];
      if (m_partition.segment(neighbor) != m_partition.segment(node))
        continue;
      if (m_rank[neighbor] > m_rank[node])
      {
        cost += graph.capacity[arc];
        continue;
      }
      cost -= graph.capacity[arc];
      const Index other = m_sets.find_set(neighbor);
      if (other != root)
        root = merge(root, other, add);
    }
    m_components[root].cost += cost;
    return root;
  }

  template <typename Add>
  Index merge(Index a, Index b, Add add)
  {
    const bool a_counts = m_components[a].area >= least_area_of_segment;
    const bool b_counts = m_components[b].area >= least_area_of_segment;
    if (a_counts && b_counts) // two branches end here
    {
      add(m_components[a]);
      add(m_components[b]);
    }
    Component larger = m_components[m_components[a].area < m_components[b].area ? b : a];
    larger.area = m_components[a].area + m_components[b].area;
    larger.cost = m_components[a].cost + m_components[b].cost;
    if (a_counts == b_counts)
      larger.forget_best();
    const Index root = m_sets.link(a, b);
    m_components[root] = larger;
    return root;
  }

  const Graph_partition& m_partition;
  std::vector<Index> m_rank;
  Disjoint_sets m_sets;
  std::vector<Component> m_components; // at the node that stands for each
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_LEVEL_SET_CUTS_H
