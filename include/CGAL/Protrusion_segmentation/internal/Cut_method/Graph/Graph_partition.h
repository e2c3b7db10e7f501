// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRAPH_PARTITION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRAPH_PARTITION_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

using Nodes = std::vector<Dual_graph::Index>;

// Connected nodes of a graph, ascending, and their area.
struct Segment
{
  Nodes nodes;
  double area;
};

// The nodes of a segment beside those of one side, ascending.
inline Nodes other_side(const Segment& segment, const Nodes& side)
{
  Nodes result;
  std::set_difference(segment.nodes.begin(), segment.nodes.end(), side.begin(), side.end(), std::back_inserter(result));
  return result;
}

inline bool are_disjoint(const Nodes& a, const Nodes& b)
{
  auto i = a.begin(), j = b.begin();
  while (i != a.end() && j != b.end() && *i != *j)
    ++(*i < *j ? i : j);
  return i == a.end() || j == b.end();
}

// A graph divided into segments, one of which is selected and divided in two sides by a cut: its inner side is marked. All
// work arrays are kept, so that an operation costs no more than the nodes it visits.
class Graph_partition
{
public:
  using Index = Dual_graph::Index;

  // `labels`: the segment of every node
  Graph_partition(const Seam_graph& graph, std::vector<Index> labels)
    : m_graph(graph), m_sides(std::move(labels)), m_visits(graph.number_of_nodes(), 0)
  {
    for (Index& side : m_sides) // still the label
      side = side_of(side, false);
  }
  // All nodes are one segment.
  explicit Graph_partition(const Seam_graph& graph)
    : Graph_partition(graph, std::vector<Index>(graph.number_of_nodes(), 0))
  {}

  const Seam_graph& graph() const { return m_graph; }
  Index label(Index node) const { return m_sides[node] / 2; }
  // Unmarks the node.
  void set_label(Index node, Index label) { m_sides[node] = side_of(label, false); }

  // Selects the segment of a label, in which no node is marked.
  void select(Index label)
  {
    m_inner = side_of(label, true);
    m_outer = side_of(label, false);
  }
  // Makes these nodes a segment of their own, with a new label, and selects it.
  void select(const Segment& segment)
  {
    select(++m_last_label);
    for (Index i : segment.nodes)
      m_sides[i] = m_outer;
  }

  bool is_inner(Index node) const { return m_sides[node] == m_inner; }
  bool is_outer(Index node) const { return m_sides[node] == m_outer; }
  bool is_selected(Index node) const { return is_inner(node) || is_outer(node); }
  bool is_on_side(Index node, bool inner) const { return m_sides[node] == (inner ? m_inner : m_outer); }
  void set_inner(Index node, bool inner) { m_sides[node] = inner ? m_inner : m_outer; }

  // Marks the nodes of `inner` and no other one of `nodes`, the selected segment.
  void mark(const Nodes& nodes, const Nodes& inner)
  {
    for (Index i : nodes)
      m_sides[i] = m_outer;
    for (Index i : inner)
      m_sides[i] = m_inner;
  }
  Nodes marked(const Nodes& nodes) const
  {
    Nodes result;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(result), [this](Index i) { return is_inner(i); });
    return result;
  }

  // Calls `visit(arc, inner node, outer node)` for all arcs of the cut. `inner`: the marked nodes
  template <typename Visit>
  void for_each_arc_of_cut(const Nodes& inner, Visit visit) const
  {
    for (Index i : inner)
    {
      CGAL_assertion(is_inner(i));
      for (Index arc : m_graph.arcs(i))
        if (const Index j = m_graph.target[arc]; is_outer(j))
          visit(arc, i, j);
    }
  }

  // The inner nodes next to an outer one, and the outer ones next to these.
  std::pair<Nodes, Nodes> nodes_along_cut(const Nodes& inner)
  {
    ++m_stamp;
    Nodes inside, outside;
    for_each_arc_of_cut(inner, [&](Index, Index i, Index j)
                        {
                          if (inside.empty() || inside.back() != i)
                            inside.push_back(i);
                          if (m_visits[j] != m_stamp)
                            outside.push_back(j);
                          m_visits[j] = m_stamp;
                        });
    return {std::move(inside), std::move(outside)};
  }

  // Whether some nodes, at least one, are connected by paths over themselves and their neighbors. Triangles around a vertex
  // need these: not all of them share edges with each other.
  bool are_connected_nearby(const Nodes& nodes)
  {
    const std::uint32_t in_set = m_stamp + 1;
    m_stamp += 2;
    for (Index i : nodes)
    {
      m_visits[i] = in_set;
      for (Index arc : m_graph.arcs(i))
        m_visits[m_graph.target[arc]] = in_set;
    }
    extend(nodes.front(), [&](Index j) { return m_visits[j] == in_set; });
    return std::none_of(nodes.begin(), nodes.end(), [&](Index i) { return m_visits[i] == in_set; });
  }

  // The nodes connected to `seed` over nodes for which `is_inside` holds.
  template <typename IsInside>
  Nodes connected_nodes(Index seed, IsInside is_inside)
  {
    ++m_stamp;
    return extend(seed, is_inside);
  }

  // Makes both sides of the cut around `inner` connected: the inner side keeps its largest component; then the outer one
  // does, and what it loses goes to the inner side. Marks the inner side and returns it. `nodes`: of the selected segment
  Nodes connect_sides(const Nodes& nodes, const Nodes& inner)
  {
    mark(nodes, inner);
    const Nodes largest = largest_component(inner, true);
    mark(nodes, largest);
    const Nodes outer = largest_component(nodes, false);
    for (Index i : nodes)
      m_sides[i] = m_inner;
    for (Index i : outer)
      m_sides[i] = m_outer;
    return marked(nodes);
  }

private:
  // A segment and one of its sides as one number: both are asked for wherever a graph is searched.
  static Index side_of(Index label, bool inner) { return 2 * label + (inner ? 1 : 0); }

  // The component of largest area among the nodes of one side; the first of equals.
  Nodes largest_component(const Nodes& nodes, bool inner)
  {
    ++m_stamp;
    Nodes largest;
    double largest_area = -1;
    for (Index i : nodes)
    {
      if (!is_on_side(i, inner) || m_visits[i] == m_stamp)
        continue;
      Nodes component = extend(i, [&](Index j) { return is_on_side(j, inner); });
      const double area = m_graph.area_of(component);
      if (area > largest_area)
      {
        largest_area = area;
        largest = std::move(component);
      }
    }
    return largest;
  }

  template <typename IsInside>
  Nodes extend(Index seed, IsInside is_inside)
  {
    Nodes nodes(1, seed);
    m_visits[seed] = m_stamp;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (Index arc : m_graph.arcs(nodes[k]))
        if (const Index j = m_graph.target[arc]; m_visits[j] != m_stamp && is_inside(j))
        {
          m_visits[j] = m_stamp;
          nodes.push_back(j);
        }
    return nodes;
  }

  const Seam_graph& m_graph;
  std::vector<Index> m_sides;          // of every node, see `side_of()`
  std::vector<std::uint32_t> m_visits; // of every node: the stamp of the last operation that reached it
  std::uint32_t m_stamp = 0;
  Index m_last_label = 0; // of `select(segment)`
  Index m_inner = 1, m_outer = 0; // sides of the selected segment
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRAPH_PARTITION_H
