// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_LEVEL_SETS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_LEVEL_SETS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A component of a level set: the nodes connected to `node` over nodes not after it in an order of the segment's nodes.
struct Level_set
{
  double relative_cost;
  Dual_graph::Index node;
};

// Finds, among all components of all sublevel sets of an order of nodes, the best one in each branch of their merge
// tree. One union-find sweep with the area and the cost of the cut around each component, nearly linear.
class Level_set_sweep
{
public:
  using Index = Dual_graph::Index;

  // The graph must outlive the object.
  explicit Level_set_sweep(const Seam_graph& graph)
    : m_graph(graph),
      m_rank(graph.number_of_nodes(), 0),
      m_sets(graph.number_of_nodes()),
      m_components(graph.number_of_nodes())
  {}

  // `order` holds the nodes of the selected segment of a partition, lowest first.
  std::vector<Level_set> operator()(const Graph_partition& partition, const Nodes& order, double segment_area)
  {
    m_level_sets.clear();
    for (std::size_t i = 0; i < order.size(); ++i)
      m_rank[order[i]] = static_cast<Index>(i);
    for (Index node : order)
    {
      Component& component = m_components[absorb(node, partition)];
      const double cost = relative_cost(component.cost, component.area, segment_area);
      if (cost < component.best)
      {
        component.best = cost;
        component.best_node = node;
      }
    }
    if (!order.empty())
      add(m_components[m_sets.find_set(order.back())]);
    return m_level_sets;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Component
  {
    double area;
    double cost;
    double best; // least relative cost since the last merger of two components
    Index best_node;
  };

  void add(const Component& component)
  {
    if (component.best < infinity)
      m_level_sets.push_back({component.best, component.best_node});
  }

  // Adds `node` to the components that it touches, merging them; returns what stands for the result.
  Index absorb(Index node, const Graph_partition& partition)
  {
    m_sets.make_set(node);
    m_components[node] = {m_graph.area[node], 0, infinity, node};
    Index root = node;
    double cost = 0;
    for (Index arc : m_graph.arcs(node))
    {
      const Index neighbor = m_graph.target[arc];
      if (!partition.is_selected(neighbor))
        continue;
      if (m_rank[neighbor] > m_rank[node])
      {
        cost += m_graph.capacity[arc];
        continue;
      }
      cost -= m_graph.capacity[arc];
      const Index other = m_sets.find_set(neighbor);
      if (other != root)
        root = merge(root, other);
    }
    m_components[root].cost += cost;
    return root;
  }

  Index merge(Index a, Index b)
  {
    const bool a_counts = m_components[a].area >= least_area_of_segment;
    const bool b_counts = m_components[b].area >= least_area_of_segment;
    if (a_counts && b_counts) // two branches end here
    {
      add(m_components[a]);
      add(m_components[b]);
      m_components[a].best = m_components[b].best = infinity;
    }
    Component larger = m_components[m_components[a].area < m_components[b].area ? b : a];
    larger.area = m_components[a].area + m_components[b].area;
    larger.cost = m_components[a].cost + m_components[b].cost;
    const Index root = m_sets.link(a, b);
    m_components[root] = larger;
    return root;
  }

  const Seam_graph& m_graph;
  std::vector<Index> m_rank;
  Disjoint_sets m_sets;
  std::vector<Component> m_components; // at the node that stands for each
  std::vector<Level_set> m_level_sets;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CANDIDATES_LEVEL_SETS_H
