// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MINIMUM_CUT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MINIMUM_CUT_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// How far a cut may move, see `refine_cut()`.
struct Band
{
  double inner;     // as a share of the depth of the inner side
  double outer;     // as a multiple of the inner width
  double outermost; // as a share of the depth of the outer side
};

// The band's nodes as a flow network with a source, the inner core, and a sink, the outer core.
class Band_network
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = Graph_partition::Nodes;

  // `number` is a work array as long as the graph, filled with `no_face()`, and so left behind.
  Band_network(const Graph_partition& partition,
               Index segment,
               const Nodes& band,
               std::vector<Index>& number)
    : m_source(static_cast<Index>(band.size())), m_sink(m_source + 1)
  {
    const Weighted_dual_graph& graph = partition.graph();
    for (Index i = 0; i < band.size(); ++i)
      number[band[i]] = i;
    std::vector<double> from_source(band.size(), 0), to_sink(band.size(), 0);
    for (Index i = 0; i < band.size(); ++i)
      for (Index arc : graph.arcs(band[i]))
      {
        const Index j = graph.target[arc];
        if (partition.segment(j) != segment)
          continue;
        if (number[j] == Indexed_surface::no_face())
          (partition.is_inner(j) ? from_source : to_sink)[i] += graph.capacity[arc];
        else if (number[j] > i)
          add_edge(i, number[j], graph.capacity[arc], graph.capacity[arc]);
      }
    for (Index i = 0; i < band.size(); ++i)
    {
      if (from_source[i] > 0)
        add_edge(m_source, i, from_source[i], 0);
      if (to_sink[i] > 0)
        add_edge(i, m_sink, to_sink[i], 0);
      m_has_source |= from_source[i] > 0;
      m_has_sink |= to_sink[i] > 0;
      number[band[i]] = Indexed_surface::no_face();
    }
  }

  bool has_terminals() const { return m_has_source && m_has_sink; }

  // Whether each node of the band lies on the source's side of the minimum cut.
  std::vector<bool> source_side()
  {
    // sort the arcs by their sources and tell every arc its opposite
    std::vector<Index> order(m_arcs.size()), position(m_arcs.size());
    for (Index a = 0; a < order.size(); ++a)
      order[a] = a;
    std::stable_sort(order.begin(), order.end(),
                     [this](Index a, Index b) { return m_arcs[a].first < m_arcs[b].first; });
    for (Index p = 0; p < order.size(); ++p)
      position[order[p]] = p;
    std::vector<std::pair<Index, Index>> arcs(order.size());
    std::vector<Arc> properties(order.size());
    for (Index p = 0; p < order.size(); ++p)
    {
      arcs[p] = m_arcs[order[p]];
      properties[p] = {m_capacities[order[p]], 0};
    }
    Graph graph(boost::edges_are_sorted, arcs.begin(), arcs.end(), properties.begin(), m_sink + 1);
    const std::vector<typename boost::graph_traits<Graph>::edge_descriptor> descriptors(
      edges(graph).first, edges(graph).second);
    std::vector<typename boost::graph_traits<Graph>::edge_descriptor> opposites(order.size());
    for (Index p = 0; p < order.size(); ++p)
      opposites[p] = descriptors[position[order[p] ^ 1]]; // arcs were added in opposite pairs

    const auto vertex_index = get(boost::vertex_index, graph);
    const auto edge_index = get(boost::edge_index, graph);
    std::vector<boost::default_color_type> colors(m_sink + 1);
    std::vector<typename boost::graph_traits<Graph>::edge_descriptor> predecessors(m_sink + 1);
    std::vector<Index> distances(m_sink + 1);
    boykov_kolmogorov_max_flow(graph, get(&Arc::capacity, graph), get(&Arc::residual, graph),
                               boost::make_iterator_property_map(opposites.begin(), edge_index),
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

  void add_edge(Index from, Index to, double capacity, double opposite_capacity)
  {
    m_arcs.emplace_back(from, to);
    m_capacities.push_back(capacity);
    m_arcs.emplace_back(to, from);
    m_capacities.push_back(opposite_capacity);
  }

  Index m_source, m_sink;
  std::vector<std::pair<Index, Index>> m_arcs;
  std::vector<double> m_capacities;
  bool m_has_source = false;
  bool m_has_sink = false;
};

// The nodes of a segment that a cut may move over.
inline Graph_partition::Nodes band_of_cut(Graph_partition& partition,
                                          Weighted_dual_graph::Index segment,
                                          const Graph_partition::Nodes& inner,
                                          const Band& band)
{
  const auto [inside, outside] = partition.nodes_along_cut(segment, inner);
  if (inside.empty())
    return {};
  Graph_partition::Nodes nodes;
  const auto take_up_to = [&nodes](const Nodes_by_distance& side, double width)
  {
    for (std::size_t i = 0; i < side.nodes.size() && side.distances[i] <= width; ++i)
      nodes.push_back(side.nodes[i]);
  };
  const auto length = partition.graph().seam_lengths();
  const Nodes_by_distance inner_side = partition.nodes_by_distance_on_side(inside, segment, true, length);
  const double inner_width = band.inner * inner_side.distances.back();
  take_up_to(inner_side, inner_width);
  const double outer_width = band.outer * inner_width;
  // how much deeper the outer side is makes no difference
  const Nodes_by_distance outer_side =
    partition.nodes_by_distance_on_side(outside, segment, false, length, outer_width / band.outermost);
  take_up_to(outer_side, (std::min)(outer_width, band.outermost * outer_side.distances.back()));
  return nodes;
}

// Replaces a cut by the cheapest one in a band around it. `inner` is the marked side of the segment with the
// nodes `nodes`; returns the new one, marked. `number` is as for `Band_network`.
inline Graph_partition::Nodes refine_cut(Graph_partition& partition,
                                         Weighted_dual_graph::Index segment,
                                         const Graph_partition::Nodes& nodes,
                                         const Graph_partition::Nodes& inner,
                                         const Band& band,
                                         std::vector<Weighted_dual_graph::Index>& number)
{
  const Graph_partition::Nodes movable = band_of_cut(partition, segment, inner, band);
  Band_network network(partition, segment, movable, number);
  if (!network.has_terminals())
    return inner;
  const std::vector<bool> is_inner = network.source_side();
  for (std::size_t i = 0; i < movable.size(); ++i)
    partition.set_inner(movable[i], is_inner[i]);
  return partition.marked(nodes);
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_MINIMUM_CUT_H
