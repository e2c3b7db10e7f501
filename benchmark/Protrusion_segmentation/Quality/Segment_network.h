// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A segment's faces as a flow network, in which minimum cuts between many pairs of places are asked for.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SEGMENT_NETWORK_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SEGMENT_NETWORK_H

#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <cstddef>
#include <utility>
#include <vector>

class Segment_network
{
public:
  // Two nodes and the cost of cutting them apart.
  struct Link
  {
    std::size_t a, b;
    double cost;
  };

  Segment_network(std::size_t number_of_nodes, const std::vector<Link>& links);

  // The side of the nodes `first` of the cheapest cut that parts them from the nodes `second`. Each of the lists has a
  // node, and none is in both.
  std::vector<bool> side_of(const std::vector<std::size_t>& first,
                            const std::vector<std::size_t>& second);

private:
  using Graph = boost::compressed_sparse_row_graph<boost::directedS>;
  using Arc = boost::graph_traits<Graph>::edge_descriptor;

  void set_terminal(std::size_t node, std::size_t terminal, double capacity);

  std::size_t m_number_of_nodes; // then come the source and the sink
  double m_unlimited = 1;        // more than any cut costs
  Graph m_graph;
  std::vector<double> m_capacities, m_residuals; // by arc
  std::vector<Arc> m_arcs, m_opposites;          // by arc
};

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SEGMENT_NETWORK_H
