// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_MINIMUM_CUT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_MINIMUM_CUT_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Graph_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Graph_partition.h>

#include <CGAL/assertions.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
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

// The band's nodes as a flow network with a source, the inner core, and a sink, the outer core.
class Band_network
{
public:
  using Index = Dual_graph::Index;

  // `number` is a work array as long as the graph, filled with `no_face()`, and so left behind.
  Band_network(const Graph_partition& partition, const Nodes& band, std::vector<Index>& number)
    : m_source(static_cast<Index>(band.size())),
      m_sink(m_source + 1),
      m_from_source(band.size(), 0),
      m_to_sink(band.size(), 0)
  {
    reserve(partition.graph(), band);
    for (Index i = 0; i < band.size(); ++i)
      number[band[i]] = i;
    for (Index i = 0; i < band.size(); ++i)
      add_arcs_of_node(partition, band, i, number);
    for (Index i : band)
      number[i] = Indexed_surface::no_face();
    add_arcs_of_terminals();
  }

  bool has_terminals() const { return m_has_source && m_has_sink; }

  // Whether each node of the band lies on the source's side of the minimum cut.
  std::vector<bool> source_side()
  {
    Graph graph(boost::edges_are_sorted, m_ends.begin(), m_ends.end(), m_arcs.begin(), m_sink + 1);
    using Edge = typename boost::graph_traits<Graph>::edge_descriptor;

    const auto vertex_index = get(boost::vertex_index, graph);
    const auto edge_index = get(boost::edge_index, graph);
    const auto opposite = [&](const Edge& edge)
    {
      const Index arc = get(edge_index, edge);
      return Edge(m_ends[arc].second, m_opposites[arc]);
    };
    std::vector<boost::default_color_type> colors(m_sink + 1);
    std::vector<Edge> predecessors(m_sink + 1);
    std::vector<Index> distances(m_sink + 1);
    boykov_kolmogorov_max_flow(graph, get(&Arc::capacity, graph), get(&Arc::residual, graph),
                               boost::make_function_property_map<Edge>(opposite),
                               boost::make_iterator_property_map(predecessors.begin(), vertex_index),
                               boost::make_iterator_property_map(colors.begin(), vertex_index),
                               boost::make_iterator_property_map(distances.begin(), vertex_index),
                               vertex_index, m_source, m_sink);
    std::vector<bool> result(m_source);
    for (Index i = 0; i < m_source; ++i)
      result[i] = colors[i] == boost::black_color;
    return result;
  }

private:
  struct Arc
  {
    double capacity;
    double residual;
  };
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Arc,
                                                   boost::no_property, Index, Index>;

  void reserve(const Seam_graph& graph, const Nodes& band)
  {
    std::size_t most_arcs = 4 * band.size(); // from and to both terminals
    for (Index node : band)
      most_arcs += graph.arcs(node).size();
    m_ends.reserve(most_arcs);
    m_arcs.reserve(most_arcs);
    m_opposites.reserve(most_arcs);
    m_next_to_higher.reserve(band.size());
  }

  // Adds the arcs from a node of the band, to others of it by their numbers. Since the nodes come in the order of their
  // numbers, too, the opposite of an arc to a lower node is the first of that node's arcs that has none yet.
  void add_arcs_of_node(const Graph_partition& partition,
                        const Nodes& band,
                        Index i,
                        const std::vector<Index>& number)
  {
    const Seam_graph& graph = partition.graph();
    m_neighbors.clear();
    for (Index arc : graph.arcs(band[i]))
    {
      const Index j = graph.target[arc];
      if (!partition.is_selected(j) || j == band[i])
        continue;
      if (number[j] == Indexed_surface::no_face())
        (partition.is_inner(j) ? m_from_source : m_to_sink)[i] += graph.capacity[arc];
      else
        m_neighbors.emplace_back(number[j], graph.capacity[arc]);
    }
    std::sort(m_neighbors.begin(), m_neighbors.end());
    m_next_to_higher.push_back(number_of_arcs());
    for (const auto& [j, capacity] : m_neighbors)
    {
      if (j < i)
      {
        add_opposite_arcs(i, j, m_next_to_higher[j]++, capacity);
        ++m_next_to_higher[i];
      }
      else
        add_arc(i, j, capacity);
    }
    for (const auto& [terminal, sum] : {std::make_pair(m_source, m_from_source[i]), std::make_pair(m_sink, m_to_sink[i])})
      if (sum > 0)
        add_arc(i, terminal, terminal == m_sink ? sum : 0);
  }

  void add_arcs_of_terminals()
  {
    const Index number_of_own = number_of_arcs();
    std::vector<Index> of_source, of_sink;
    for (Index a = 0; a < number_of_own; ++a)
      if (m_ends[a].second >= m_source)
        (m_ends[a].second == m_source ? of_source : of_sink).push_back(a);
    for (Index a : of_source)
      add_opposite_arcs(m_source, m_ends[a].first, a, m_from_source[m_ends[a].first]);
    for (Index a : of_sink)
      add_opposite_arcs(m_sink, m_ends[a].first, a, 0);
    m_has_source = !of_source.empty();
    m_has_sink = !of_sink.empty();
  }

  Index number_of_arcs() const { return static_cast<Index>(m_ends.size()); }

  void add_arc(Index from, Index to, double capacity)
  {
    m_ends.emplace_back(from, to);
    m_arcs.push_back({capacity, 0});
    m_opposites.push_back(number_of_arcs()); // not known yet
  }
  void add_opposite_arcs(Index from, Index to, Index opposite, double capacity)
  {
    CGAL_assertion(m_ends[opposite] == std::make_pair(to, from));
    add_arc(from, to, capacity);
    m_opposites.back() = opposite;
    m_opposites[opposite] = number_of_arcs() - 1;
  }

  Index m_source, m_sink;
  std::vector<double> m_from_source, m_to_sink; // capacities, of every node
  std::vector<std::pair<Index, Index>> m_ends;  // of the arcs, sorted by their sources
  std::vector<Arc> m_arcs;
  std::vector<Index> m_opposites;
  std::vector<Index> m_next_to_higher; // of every node the first arc to a higher one without an opposite
  std::vector<std::pair<Index, float>> m_neighbors; // of one node
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

private:
  // The nodes that a cut may move over.
  Nodes nodes_of_band(const Nodes& inner, const Band& band)
  {
    const auto [inside, outside] = m_partition.nodes_along_cut(inner);
    if (inside.empty())
      return {};
    // no need to know more of the depth than what limits the width
    const Nodes_by_distance inner_side = on_side(inside, true, band.widest / band.inner);
    const double inner_width = (std::min)(band.widest, band.inner * inner_side.distances.back());
    const double outer_width = band.outer * inner_width;
    const Nodes_by_distance outer_side = on_side(outside, false, outer_width / band.outermost);
    Nodes nodes;
    append_up_to(inner_width, inner_side, nodes);
    append_up_to((std::min)(outer_width, band.outermost * outer_side.distances.back()), outer_side, nodes);
    return nodes;
  }

  Nodes_by_distance on_side(const Nodes& seeds, bool inner, double limit)
  {
    return m_distances(
      seeds, [&](Index, Index to) { return m_partition.is_on_side(to, inner); }, m_partition.graph().seam_lengths(), limit);
  }

  static void append_up_to(double width, const Nodes_by_distance& side, Nodes& nodes)
  {
    for (std::size_t i = 0; i < side.nodes.size() && side.distances[i] <= width; ++i)
      nodes.push_back(side.nodes[i]);
  }

  Graph_partition& m_partition;
  Graph_distances& m_distances;
  std::vector<Index> m_number; // of every node, see `Band_network`
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_MINIMUM_CUT_H
