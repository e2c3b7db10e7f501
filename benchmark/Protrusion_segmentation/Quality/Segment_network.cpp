// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Segment_network.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <map>

Segment_network::Segment_network(std::size_t number_of_nodes, const std::vector<Link>& links)
  : m_number_of_nodes(number_of_nodes)
{
  using Ends = std::pair<std::size_t, std::size_t>;
  std::map<Ends, double> capacities; // in the order that the graph wants
  for (const Link& link : links)
  {
    capacities[{link.a, link.b}] += link.cost;
    capacities[{link.b, link.a}] += link.cost;
    m_unlimited += link.cost;
  }
  for (std::size_t node = 0; node < number_of_nodes; ++node)
    for (const std::size_t terminal : {number_of_nodes, number_of_nodes + 1})
      capacities[{node, terminal}] = capacities[{terminal, node}] = 0;

  std::vector<Ends> ends;
  std::map<Ends, std::size_t> numbers;
  for (const auto& [arc, capacity] : capacities)
  {
    numbers[arc] = ends.size();
    ends.push_back(arc);
    m_capacities.push_back(capacity);
  }
  m_graph = Graph(boost::edges_are_sorted, ends.begin(), ends.end(), number_of_nodes + 2, ends.size());
  m_arcs.assign(edges(m_graph).first, edges(m_graph).second);
  for (const auto& [from, to] : ends)
    m_opposites.push_back(m_arcs[numbers[{to, from}]]);
}

// The arcs from a node to source and sink are its last two.
void Segment_network::set_terminal(std::size_t node, std::size_t terminal, double capacity)
{
  const bool is_sink = terminal == m_number_of_nodes + 1;
  const auto last = *(out_edges(node, m_graph).second - 1);
  const std::size_t arc = get(boost::edge_index, m_graph, last) - (is_sink ? 0 : 1);
  m_capacities[is_sink ? arc : get(boost::edge_index, m_graph, m_opposites[arc])] = capacity;
}

std::vector<bool> Segment_network::side_of(const std::vector<std::size_t>& first,
                                           const std::vector<std::size_t>& second)
{
  const std::size_t source = m_number_of_nodes, sink = m_number_of_nodes + 1;
  for (const std::size_t node : first)
    set_terminal(node, source, m_unlimited);
  for (const std::size_t node : second)
    set_terminal(node, sink, m_unlimited);

  const auto vertex_index = get(boost::vertex_index, m_graph);
  const auto edge_index = get(boost::edge_index, m_graph);
  m_residuals.resize(m_capacities.size());
  std::vector<boost::default_color_type> colors(sink + 1);
  std::vector<Arc> predecessors(sink + 1);
  std::vector<long> distances(sink + 1);
  boost::boykov_kolmogorov_max_flow(
    m_graph, boost::make_iterator_property_map(m_capacities.begin(), edge_index),
    boost::make_iterator_property_map(m_residuals.begin(), edge_index),
    boost::make_iterator_property_map(m_opposites.begin(), edge_index),
    boost::make_iterator_property_map(predecessors.begin(), vertex_index),
    boost::make_iterator_property_map(colors.begin(), vertex_index),
    boost::make_iterator_property_map(distances.begin(), vertex_index), vertex_index, source, sink);

  for (const std::size_t node : first)
    set_terminal(node, source, 0);
  for (const std::size_t node : second)
    set_terminal(node, sink, 0);
  std::vector<bool> result(m_number_of_nodes);
  for (std::size_t node = 0; node < m_number_of_nodes; ++node)
    result[node] = colors[node] == boost::black_color;
  return result;
}
