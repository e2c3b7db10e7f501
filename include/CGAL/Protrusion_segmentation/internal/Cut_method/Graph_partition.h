// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PARTITION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PARTITION_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Bucket_ring.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Float_key.h>

#include <boost/range/adaptor/transformed.hpp>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Nodes in ascending order of their distances from some others.
struct Nodes_by_distance
{
  std::vector<Weighted_dual_graph::Index> nodes;
  std::vector<double> distances; // of each of these nodes
};

// A weighted dual graph divided into connected segments, and the elementary operations on one of them. All work
// arrays are kept, so that an operation costs no more than the nodes it visits.
//
// A cut divides one segment in two sides, the inner and the outer one. While it is worked on, the nodes of the
// inner side are marked.
class Graph_partition
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = std::vector<Index>;

  Graph_partition(const Weighted_dual_graph& graph, std::vector<Index> segments)
    : m_graph(graph),
      m_sides(std::move(segments)),
      m_visits(graph.number_of_nodes()),
      m_distances(graph.number_of_nodes(), unreached),
      m_ring(ring_for(graph))
  {
    for (Index& side : m_sides) // still the segment
      side = side_of(side, false);
    for (double area : graph.area)
      m_largest_size = (std::max)(m_largest_size, std::sqrt(area));
  }

  const Weighted_dual_graph& graph() const { return m_graph; }
  // of a node: the square root of its area
  double largest_size() const { return m_largest_size; }
  Index segment(Index node) const { return m_sides[node] / 2; }
  std::vector<Index> segments() const
  {
    std::vector<Index> result(m_sides.size());
    std::transform(m_sides.begin(), m_sides.end(), result.begin(), [](Index side) { return side / 2; });
    return result;
  }
  void set_segment(Index node, Index segment) { m_sides[node] = side_of(segment, is_inner(node)); }

  bool is_inner(Index node) const { return m_sides[node] % 2 == 1; }
  void set_inner(Index node, bool value) { m_sides[node] = side_of(segment(node), value); }
  bool is_on_side(Index node, Index segment, bool inner) const { return m_sides[node] == side_of(segment, inner); }
  // Marks the nodes of `inner` and no other node of `nodes`.
  void mark(const Nodes& nodes, const Nodes& inner)
  {
    for (Index i : nodes)
      set_inner(i, false);
    for (Index i : inner)
      set_inner(i, true);
  }
  Nodes marked(const Nodes& nodes) const
  {
    Nodes result;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(result), [this](Index i) { return is_inner(i); });
    return result;
  }

  double area(const Nodes& nodes) const { return m_graph.area_of(nodes); }

  // Calls `visit(arc, inner node, outer node)` for all arcs from the marked nodes `inner` to the rest of their
  // segment.
  template <typename Visit>
  void for_each_arc_of_cut(Index segment, const Nodes& inner, Visit visit) const
  {
    for (Index i : inner)
    {
      CGAL_assertion(is_on_side(i, segment, true));
      for (Index arc : m_graph.arcs(i))
      {
        const Index j = m_graph.target[arc];
        if (is_on_side(j, segment, false))
          visit(arc, i, j);
      }
    }
  }

  // The marked nodes next to an unmarked one of the segment, and those next to them on the other side.
  std::pair<Nodes, Nodes> nodes_along_cut(Index segment, const Nodes& inner)
  {
    ++m_stamp;
    Nodes inside, outside;
    for_each_arc_of_cut(segment, inner, [&](Index, Index i, Index j)
                        {
                          if (inside.empty() || inside.back() != i)
                            inside.push_back(i);
                          if (m_visits[j].stamp != m_stamp)
                            outside.push_back(j);
                          m_visits[j].stamp = m_stamp;
                        });
    return {std::move(inside), std::move(outside)};
  }

  // Dijkstra's algorithm from several nodes over the nodes for which `is_inside` holds, up to `limit`, with
  // lengths `length(arc)`. Equal distances are in the order of the numbers of the nodes.
  template <typename IsInside, typename Length>
  Nodes_by_distance nodes_by_distance(const Nodes& seeds,
                                      IsInside is_inside,
                                      Length length,
                                      double limit = (std::numeric_limits<double>::infinity)())
  {
    Nodes_by_distance result;
    visit_by_distance(seeds, is_inside, length, limit,
                      [&result](Index node, float distance)
                      {
                        result.nodes.push_back(node);
                        result.distances.push_back(distance);
                      });
    return result;
  }
  // The last of these nodes and its distance.
  template <typename IsInside, typename Length>
  std::pair<Index, double> farthest_node(const Nodes& seeds, IsInside is_inside, Length length)
  {
    std::pair<Index, double> result;
    visit_by_distance(seeds, is_inside, length, (std::numeric_limits<double>::infinity)(),
                      [&result](Index node, float distance) { result = {node, distance}; });
    return result;
  }
  // The same over one side of a cut.
  template <typename Length>
  Nodes_by_distance nodes_by_distance_on_side(const Nodes& seeds,
                                              Index segment,
                                              bool inner,
                                              Length length,
                                              double limit = (std::numeric_limits<double>::infinity)())
  {
    return nodes_by_distance(
      seeds, [this, side = side_of(segment, inner)](Index i) { return m_sides[i] == side; }, length, limit);
  }

  // What the border of a set costs within a side of a cut, if of each node the given share lies in the set, of all
  // others nothing.
  double cost_around(const Nodes& nodes, const std::vector<float>& shares, Index segment, bool inner)
  {
    ++m_stamp;
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      m_visits[nodes[k]] = {m_stamp, shares[k]};
    }
    double cost = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (Index arc : m_graph.arcs(nodes[k]))
      {
        const Index j = m_graph.target[arc];
        const float share = m_visits[j].stamp == m_stamp ? m_visits[j].share : 0;
        if (is_on_side(j, segment, inner) && share < shares[k])
          cost += m_graph.capacity[arc] * (shares[k] - share);
      }
    return cost;
  }

  // Whether a set of nodes, not empty, is connected in itself.
  bool are_connected(const Nodes& nodes)
  {
    const std::uint32_t in_set = m_stamp + 1;
    m_stamp += 2;
    for (Index i : nodes)
      m_visits[i].stamp = in_set;
    return extend(nodes.front(), [&](Index j) { return m_visits[j].stamp == in_set; }).size() == nodes.size();
  }

  // The nodes connected to `seed` over nodes for which `is_inside` holds.
  template <typename IsInside>
  Nodes connected_nodes(Index seed, IsInside is_inside)
  {
    ++m_stamp;
    return extend(seed, is_inside);
  }

  // Makes both sides of a cut connected and marks the inner one: it keeps its largest component; then the
  // outer one does, and what that loses goes to the inner side. Returns the inner side in the order of
  // `nodes`, those of the segment.
  Nodes connect_sides(const Nodes& nodes, Index segment, const Nodes& inner)
  {
    mark(nodes, inner);
    return connect_other_side(nodes, segment, largest_component(inner, segment, true), false);
  }

  // The same around connected nodes of a connected segment, where only the other side may be in pieces. Marks the side with
  // these nodes, or else the other one, and returns it.
  Nodes connect_other_side(const Nodes& nodes, Index segment, const Nodes& connected, bool marks_other_side)
  {
    mark(nodes, connected);
    const Nodes rest = largest_component(nodes, segment, false);
    for (Index i : nodes)
      set_inner(i, !marks_other_side);
    for (Index i : rest)
      set_inner(i, marks_other_side);
    return marked(nodes);
  }

private:
  // of a node, by the last operation that reached it
  struct Last_visit
  {
    std::uint32_t stamp = 0;
    float share = 0; // see `cost_around()`
  };

  // A segment and one of its sides as one number: both are asked for wherever a graph is searched.
  static Index side_of(Index segment, bool inner) { return 2 * segment + (inner ? 1 : 0); }

  // The component of largest area among the nodes of one side; the first of equals.
  Nodes largest_component(const Nodes& nodes, Index segment, bool inner)
  {
    ++m_stamp;
    Nodes largest;
    double largest_area = -1;
    for (Index i : nodes)
    {
      if (is_inner(i) != inner || m_visits[i].stamp == m_stamp)
        continue;
      Nodes component = extend(i, [this, side = side_of(segment, inner)](Index j) { return m_sides[j] == side; });
      const double component_area = area(component);
      if (component_area > largest_area)
      {
        largest_area = component_area;
        largest = std::move(component);
      }
    }
    return largest;
  }

  using Ring = Bucket_ring<Index, float>;
  static constexpr float unreached = (std::numeric_limits<float>::infinity)();

  // Of the longest that paths are searched with.
  static Ring ring_for(const Weighted_dual_graph& graph)
  {
    Arc_lengths lengths;
    for (Index i = 0; i < graph.number_of_nodes(); ++i)
      lengths.add_vertex(graph.arcs(i) | boost::adaptors::transformed(graph.seam_lengths()));
    return Ring::for_all(lengths);
  }

  template <typename IsInside, typename Length, typename Visit>
  void visit_by_distance(const Nodes& seeds, IsInside is_inside, Length length, double limit, Visit visit)
  {
    float* const distances = m_distances.data();
    for (Index seed : seeds)
    {
      distances[seed] = 0;
      m_ring.push_source(seed);
    }
    m_ring.scan_all([=](Index node) { return distances[node]; },
                    [&, distances](Index node, Ring::Offer* end)
                    {
                      m_scanned.push_back(node);
                      const float to_node = distances[node];
                      for (Index arc : m_graph.arcs(node))
                      {
                        const Index neighbor = m_graph.target[arc];
                        const float distance = to_node + static_cast<float>(length(arc));
                        *end = {distance, neighbor, node};
                        end += (distance < distances[neighbor]) & (distance <= limit) & is_inside(neighbor);
                      }
                      return end;
                    },
                    [=](const Ring::Offer& path) { distances[path.vertex] = path.distance; },
                    [&] { visit_in_order(visit); });
    for (Index node : m_reached)
      distances[node] = unreached;
    m_reached.clear();
  }

  // The nodes that were scanned, whose distances are final, each once.
  template <typename Visit>
  void visit_in_order(Visit visit)
  {
    m_keys.clear();
    for (Index node : m_scanned)
      m_keys.push_back(float_key(m_distances[node], node));
    m_reached.insert(m_reached.end(), m_scanned.begin(), m_scanned.end());
    m_scanned.clear();
    std::sort(m_keys.begin(), m_keys.end());
    m_keys.erase(std::unique(m_keys.begin(), m_keys.end()), m_keys.end());
    for (Float_key key : m_keys)
      visit(index_of(key), float_of(key));
  }

  template <typename IsInside>
  Nodes extend(Index seed, IsInside is_inside)
  {
    Nodes nodes(1, seed);
    m_visits[seed].stamp = m_stamp;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (Index arc : m_graph.arcs(nodes[k]))
      {
        const Index j = m_graph.target[arc];
        if (m_visits[j].stamp != m_stamp && is_inside(j))
        {
          m_visits[j].stamp = m_stamp;
          nodes.push_back(j);
        }
      }
    return nodes;
  }

  const Weighted_dual_graph& m_graph;
  double m_largest_size = 0;
  std::vector<Index> m_sides;       // of every node, see `side_of()`
  std::vector<Last_visit> m_visits; // of every node
  std::uint32_t m_stamp = 0;
  // of a search by distance
  std::vector<float> m_distances; // of every node
  Nodes m_reached;                // whose distances are to be forgotten, some more than once
  Nodes m_scanned;                // in the current bucket, some more than once
  std::vector<Float_key> m_keys;  // of these, each once, in order
  Ring m_ring;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_PARTITION_H
