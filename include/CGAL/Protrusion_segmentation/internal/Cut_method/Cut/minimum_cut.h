// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_MINIMUM_CUT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_MINIMUM_CUT_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>

#include <CGAL/boost/graph/Alpha_expansion_MaxFlow_tag.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// How far a cut may move.
struct Band
{
  double inner;     // as a share of the depth of the inner side
  double outer;     // as a multiple of the inner width
  double outermost; // as a share of the depth of the outer side
  double widest = (std::numeric_limits<double>::infinity)(); // the inner width at most
};

// The band's nodes as a flow network, whose source is the inner core and whose sink is the outer core.
class Band_network
{
public:
  using Index = Dual_graph::Index;

  // `number` is a work array as long as the graph, filled with `no_face()`, and so left behind.
  Band_network(const Graph_partition& partition, const Nodes& band, std::vector<Index>& number)
  {
    for (Index i = 0; i < band.size(); ++i)
    {
      number[band[i]] = i;
      m_nodes.push_back(m_flow.add_node());
    }
    for (Index i = 0; i < band.size(); ++i)
      add_arcs_of_node(partition, band[i], i, number);
    for (Index i : band)
      number[i] = Indexed_surface::no_face();
  }

  bool has_terminals() const { return m_has_source && m_has_sink; }

  // Whether each node of the band lies on the source's side of the minimum cut.
  std::vector<bool> source_side()
  {
    m_flow.maxflow();
    std::vector<bool> result(m_nodes.size());
    for (std::size_t i = 0; i < m_nodes.size(); ++i)
      result[i] = m_flow.what_segment(m_nodes[i]) == MaxFlow::Graph::SOURCE;
    return result;
  }

private:
  void add_arcs_of_node(const Graph_partition& partition, Index node, Index i, const std::vector<Index>& number)
  {
    const Seam_graph& graph = partition.graph();
    double from_source = 0, to_sink = 0;
    for (Index arc : graph.arcs(node))
    {
      const Index j = graph.target[arc];
      const double capacity = graph.capacity[arc];
      if (!partition.is_selected(j))
        continue;
      if (number[j] == Indexed_surface::no_face())
        (partition.is_inner(j) ? from_source : to_sink) += capacity;
      else if (number[j] < i)
        m_flow.add_edge(m_nodes[i], m_nodes[number[j]], capacity, capacity);
    }
    m_flow.add_tweights(m_nodes[i], from_source, to_sink);
    m_has_source = m_has_source || from_source > 0;
    m_has_sink = m_has_sink || to_sink > 0;
  }

  MaxFlow::Graph m_flow;
  std::vector<MaxFlow::Graph::node_id> m_nodes; // of the band
  bool m_has_source = false;
  bool m_has_sink = false;
};

// Finds the minimum cut in a band around a cut. Work arrays are kept.
class Minimum_cut
{
public:
  using Index = Dual_graph::Index;

  // The arguments must outlive the object.
  Minimum_cut(Graph_partition& partition, Graph_distances& distances)
    : m_partition(partition), m_distances(distances), m_number(partition.graph().number_of_nodes(), Indexed_surface::no_face())
  {}

  // The nodes that lie on the other side of the minimum cut. `inner`: the marked side of the selected segment
  Nodes nodes_to_move(const Nodes& inner, const Band& band)
  {
    const Nodes movable = nodes_of_band(inner, band);
    m_number_of_nodes += movable.size();
    Band_network network(m_partition, movable, m_number);
    Nodes result;
    if (!network.has_terminals())
      return result;
    const std::vector<bool> is_inner = network.source_side();
    for (std::size_t i = 0; i < movable.size(); ++i)
      if (m_partition.is_inner(movable[i]) != is_inner[i])
        result.push_back(movable[i]);
    std::sort(result.begin(), result.end());
    return result;
  }

  // in the bands of all cuts
  std::size_t number_of_nodes() const { return m_number_of_nodes; }

private:
  // The nodes that a cut may move over.
  Nodes nodes_of_band(const Nodes& inner, const Band& band)
  {
    const auto [inside, outside] = m_partition.nodes_along_cut(inner);
    if (inside.empty())
      return {};
    // no need to know more of the depth than what limits the width
    const Nodes_by_distance inner_side = on_side(inside, true, band.widest / band.inner);
    const double inner_width = (std::min)(band.widest, band.inner * depth(inner_side));
    const double outer_width = band.outer * inner_width;
    const Nodes_by_distance outer_side = on_side(outside, false, outer_width / band.outermost);
    Nodes nodes;
    append_up_to(inner_width, inner_side, nodes);
    append_up_to((std::min)(outer_width, band.outermost * depth(outer_side)), outer_side, nodes);
    return nodes;
  }

  Nodes_by_distance on_side(const Nodes& seeds, bool inner, double limit)
  {
    return m_distances.in_any_order(
      seeds, [&](Index, Index to) { return m_partition.is_on_side(to, inner); }, m_distances.seam_lengths(), limit);
  }

  static double depth(const Nodes_by_distance& side)
  {
    return *std::max_element(side.distances.begin(), side.distances.end());
  }

  void append_up_to(double width, const Nodes_by_distance& side, Nodes& nodes) const
  {
    constexpr std::size_t most_arcs = 1000; // of a node of `MaxFlow::Graph`: its blocks of arcs have 1024
    for (std::size_t i = 0; i < side.nodes.size(); ++i)
      if (side.distances[i] <= width && m_partition.graph().arcs(side.nodes[i]).size() <= most_arcs)
        nodes.push_back(side.nodes[i]);
  }

  Graph_partition& m_partition;
  Graph_distances& m_distances;
  std::vector<Index> m_number; // of every node, see `Band_network`
  std::size_t m_number_of_nodes = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_MINIMUM_CUT_H
