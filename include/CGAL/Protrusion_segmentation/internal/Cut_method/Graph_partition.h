// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PARTITION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PARTITION_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A seam graph divided into connected parts, and the elementary operations on one part of it. All work
// arrays are kept, so that an operation costs no more than the nodes it visits.
//
// A cut divides one part in two sides. While it is worked on, the nodes of the inner side are marked.
class Graph_partition
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = std::vector<Index>;

  explicit Graph_partition(const Weighted_dual_graph& graph, std::vector<Index> labels)
    : m_graph(graph),
      m_labels(std::move(labels)),
      m_is_inner(graph.number_of_nodes(), false),
      m_stamps(graph.number_of_nodes(), 0),
      m_distances(graph.number_of_nodes(), 0)
  {}

  const Weighted_dual_graph& graph() const { return m_graph; }
  const std::vector<Index>& labels() const { return m_labels; }
  Index label(Index node) const { return m_labels[node]; }
  void set_label(Index node, Index label) { m_labels[node] = label; }

  bool is_inner(Index node) const { return m_is_inner[node]; }
  void set_inner(Index node, bool value) { m_is_inner[node] = value; }
  // Marks the nodes of `inner` and no other node of `part`.
  void mark(const Nodes& part, const Nodes& inner)
  {
    for (Index i : part)
      m_is_inner[i] = false;
    for (Index i : inner)
      m_is_inner[i] = true;
  }

  double area(const Nodes& nodes) const
  {
    double sum = 0;
    for (Index i : nodes)
      sum += m_graph.area[i];
    return sum;
  }

  // Dijkstra's algorithm from several nodes over the nodes for which `is_inside` holds, up to `limit`, with
  // lengths `length(arc)`. Returns the nodes in ascending order of their distances, equal ones in
  // the order of their numbers.
  template <typename IsInside, typename Length>
  Nodes nodes_by_distance(const Nodes& seeds,
                          IsInside is_inside,
                          Length length,
                          double limit = (std::numeric_limits<double>::infinity)())
  {
    Nodes order;
    ++m_stamp;
    m_heap.clear();
    for (Index seed : seeds)
      offer(seed, 0);
    while (!m_heap.empty())
    {
      std::pop_heap(m_heap.begin(), m_heap.end(), std::greater<>());
      const auto [distance, node] = m_heap.back();
      m_heap.pop_back();
      if (distance > m_distances[node])
        continue;
      if (distance > limit)
        break;
      order.push_back(node);
      for (Index arc : m_graph.arcs(node))
        if (is_inside(m_graph.target[arc]))
          offer(m_graph.target[arc], distance + length(arc));
    }
    return order;
  }
  // the distance that the last search found for a node of its result
  double distance(Index node) const { return m_distances[node]; }

  // The nodes connected to `seed` over nodes for which `is_inside` holds.
  template <typename IsInside>
  Nodes connected_nodes(Index seed, IsInside is_inside)
  {
    ++m_stamp;
    return extend(seed, is_inside);
  }

  // The component of largest area among the nodes of one side; the first of equals.
  Nodes largest_component(const Nodes& nodes, Index part, bool inner)
  {
    ++m_stamp;
    Nodes largest;
    double largest_area = -1;
    for (Index i : nodes)
    {
      if (m_is_inner[i] != inner || m_stamps[i] == m_stamp)
        continue;
      Nodes component = extend(i, [&](Index j) { return m_labels[j] == part && m_is_inner[j] == inner; });
      const double component_area = area(component);
      if (component_area > largest_area)
      {
        largest_area = component_area;
        largest = std::move(component);
      }
    }
    return largest;
  }

  // Makes both sides of a cut connected and marks the inner one: it keeps its largest component; then the
  // outer one does, and what that loses goes to the inner side. Returns the inner side in the order of
  // `part`.
  Nodes connect_sides(const Nodes& part, Index part_label, const Nodes& inner)
  {
    mark(part, inner);
    const Nodes main = largest_component(inner, part_label, true);
    mark(part, main);
    const Nodes rest = largest_component(part, part_label, false);
    for (Index i : part)
      m_is_inner[i] = true;
    for (Index i : rest)
      m_is_inner[i] = false;
    return inner_nodes(part);
  }

  Nodes inner_nodes(const Nodes& part) const
  {
    Nodes result;
    for (Index i : part)
      if (m_is_inner[i])
        result.push_back(i);
    return result;
  }

  // The marked nodes next to an unmarked one of the part, and those next to them on the other side.
  std::pair<Nodes, Nodes> nodes_along_cut(Index part_label, const Nodes& inner)
  {
    ++m_stamp;
    Nodes inside, outside;
    for (Index i : inner)
    {
      bool is_on_cut = false;
      for (Index arc : m_graph.arcs(i))
      {
        const Index j = m_graph.target[arc];
        if (m_labels[j] != part_label || m_is_inner[j])
          continue;
        is_on_cut = true;
        if (m_stamps[j] != m_stamp)
          outside.push_back(j);
        m_stamps[j] = m_stamp;
      }
      if (is_on_cut)
        inside.push_back(i);
    }
    return {std::move(inside), std::move(outside)};
  }

private:
  void offer(Index node, double distance)
  {
    if (m_stamps[node] == m_stamp && m_distances[node] <= distance)
      return;
    m_stamps[node] = m_stamp;
    m_distances[node] = distance;
    m_heap.emplace_back(distance, node);
    std::push_heap(m_heap.begin(), m_heap.end(), std::greater<>());
  }

  template <typename IsInside>
  Nodes extend(Index seed, IsInside is_inside)
  {
    Nodes nodes(1, seed);
    m_stamps[seed] = m_stamp;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (Index arc : m_graph.arcs(nodes[k]))
      {
        const Index j = m_graph.target[arc];
        if (m_stamps[j] != m_stamp && is_inside(j))
        {
          m_stamps[j] = m_stamp;
          nodes.push_back(j);
        }
      }
    return nodes;
  }

  const Weighted_dual_graph& m_graph;
  std::vector<Index> m_labels; // the part of every node
  std::vector<bool> m_is_inner;
  std::vector<std::uint32_t> m_stamps; // the last operation that reached a node
  std::uint32_t m_stamp = 0;
  std::vector<double> m_distances;
  std::vector<std::pair<double, Index>> m_heap;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PARTITION_H
