// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_GRAPH_DISTANCES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_GRAPH_DISTANCES_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Bucket_ring.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Float_key.h>

#include <boost/range/adaptor/transformed.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Nodes in ascending order of their distances from some others.
struct Nodes_by_distance
{
  Nodes nodes;
  std::vector<double> distances; // of each of these nodes
};

// Dijkstra's algorithm on a graph. Work arrays are kept, so that it costs no more than the nodes it reaches.
class Graph_distances
{
public:
  using Index = Dual_graph::Index;
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  // The graph must outlive the object.
  explicit Graph_distances(const Seam_graph& graph)
    : m_graph(graph), m_distances(graph.number_of_nodes(), unreached), m_ring(ring_for(graph))
  {}

  // From the nodes `seeds` over nodes for which `is_inside(from, to)` holds, up to `limit`, with lengths `length(arc)` that
  // are at most seam lengths. Equal distances are in the order of the numbers of the nodes.
  template <typename IsInside, typename Length>
  Nodes_by_distance operator()(const Nodes& seeds, IsInside is_inside, Length length, double limit = unbounded)
  {
    Nodes_by_distance result;
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
                        end += (distance < distances[neighbor]) & (distance <= limit) & is_inside(node, neighbor);
                      }
                      return end;
                    },
                    [=](const Ring::Offer& path) { distances[path.vertex] = path.distance; },
                    [&] { append_scanned(result); });
    for (Index node : result.nodes)
      distances[node] = unreached;
    return result;
  }

private:
  using Ring = Bucket_ring<Index, float>;
  static constexpr float unreached = std::numeric_limits<float>::infinity();

  static Ring ring_for(const Seam_graph& graph)
  {
    Arc_lengths lengths;
    for (Index i = 0; i < graph.number_of_nodes(); ++i)
      lengths.add_vertex(graph.arcs(i) | boost::adaptors::transformed(graph.seam_lengths()));
    return Ring(lengths);
  }

  // The nodes that were scanned in a bucket, whose distances are final, each once.
  void append_scanned(Nodes_by_distance& result)
  {
    m_keys.clear();
    for (Index node : m_scanned)
      m_keys.push_back(float_key(m_distances[node], node));
    m_scanned.clear();
    std::sort(m_keys.begin(), m_keys.end());
    m_keys.erase(std::unique(m_keys.begin(), m_keys.end()), m_keys.end());
    for (Float_key key : m_keys)
    {
      result.nodes.push_back(index_of(key));
      result.distances.push_back(float_of(key));
    }
  }

  const Seam_graph& m_graph;
  std::vector<float> m_distances; // of every node
  Ring m_ring;
  Nodes m_scanned;               // in the current bucket, some more than once
  std::vector<Float_key> m_keys; // of these, each once, in order
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_GRAPH_DISTANCES_H
