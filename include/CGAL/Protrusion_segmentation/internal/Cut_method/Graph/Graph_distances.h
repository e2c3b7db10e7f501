// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRAPH_DISTANCES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRAPH_DISTANCES_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Bucket_ring.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Float_key.h>

#include <boost/range/adaptor/transformed.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// What a `Bucket_ring` must know of paths of seam lengths.
template <typename Graph>
Arc_lengths seam_lengths_of_arcs(const Graph& graph)
{
  Arc_lengths lengths;
  for (Dual_graph::Index i = 0; i < graph.number_of_nodes(); ++i)
    lengths.add_vertex(graph.arcs(i) | boost::adaptors::transformed([&](Dual_graph::Index arc) { return graph.seam_length(arc); }));
  return lengths;
}

// Nodes and their distances from some others.
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
    : m_graph(graph),
      m_seam_lengths(seam_lengths_of(graph)),
      m_distances(graph.number_of_nodes(), unreached),
      m_ring(seam_lengths_of_arcs(graph))
  {}

  // The seam lengths, as a function of an arc that must not outlive the object.
  auto seam_lengths() const
  {
    return [lengths = m_seam_lengths.data()](Index arc) { return lengths[arc]; };
  }

  // From the nodes `seeds` over nodes for which `is_inside(from, to)` holds, up to `limit`, with lengths `length(arc)` that
  // are at most seam lengths. The nodes are in ascending order of their distances, equal ones in that of their numbers.
  template <typename IsInside, typename Length>
  Nodes_by_distance operator()(const Nodes& seeds,
                               IsInside is_inside,
                               Length length,
                               double limit = unbounded)
  {
    Nodes_by_distance result;
    scan(seeds, is_inside, length, limit, [&] { append_scanned(result); });
    for (Index node : result.nodes)
      m_distances[node] = unreached;
    m_number_of_nodes += result.nodes.size();
    return result;
  }

  // The same in any order.
  template <typename IsInside, typename Length>
  Nodes_by_distance in_any_order(const Nodes& seeds,
                                 IsInside is_inside,
                                 Length length,
                                 double limit = unbounded)
  {
    Nodes_by_distance result;
    scan(seeds, is_inside, length, limit, [] {});
    for (Index node : m_scanned)
      if (m_distances[node] != unreached) // else it has been scanned more than once
      {
        result.nodes.push_back(node);
        result.distances.push_back(m_distances[node]);
        m_distances[node] = unreached;
      }
    m_number_of_nodes += result.nodes.size();
    m_scanned.clear();
    return result;
  }

  // that were reached over all runs
  std::size_t number_of_nodes() const { return m_number_of_nodes; }

private:
  using Ring = Bucket_ring<Index, float>;
  static constexpr float unreached = std::numeric_limits<float>::infinity();

  // Calls `leave_bucket()` when the distances of all nodes in `m_scanned` are final.
  template <typename IsInside, typename Length, typename LeaveBucket>
  void scan(const Nodes& seeds, IsInside is_inside, Length length, double limit, LeaveBucket leave_bucket)
  {
    float* const distances = m_distances.data();
    for (Index seed : seeds)
    {
      distances[seed] = 0;
      m_ring.push_source(seed);
    }
    m_ring.scan_all(
      [=](Index node) { return distances[node]; },
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
      [=](const Ring::Offer& path) { distances[path.vertex] = path.distance; }, leave_bucket);
  }

  static std::vector<float> seam_lengths_of(const Seam_graph& graph)
  {
    std::vector<float> result(graph.target.size());
    for (Index arc = 0; arc < result.size(); ++arc)
      result[arc] = graph.seam_length(arc);
    return result;
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
  std::vector<float> m_seam_lengths; // of every arc
  std::vector<float> m_distances;    // of every node
  Ring m_ring;
  Nodes m_scanned;               // some more than once
  std::vector<Float_key> m_keys; // of these, each once, in order
  std::size_t m_number_of_nodes = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRAPH_DISTANCES_H
