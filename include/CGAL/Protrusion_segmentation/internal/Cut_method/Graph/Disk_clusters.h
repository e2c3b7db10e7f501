// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DISK_CLUSTERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DISK_CLUSTERS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/contract_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Bucket_ring.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Divides a connected graph into clusters by a Poisson disk sampling: seeds that are farther from each other than a
// radius, so many that no node is farther from all of them. Every node goes to the nearest seed, with arcs across concave seams
// longer, if the graph has seams. Clusters are connected.
//
// Which nodes become seeds depends on the places of the nodes in the canonical frame of the surface: their order is that of
// random numbers of the cells of a grid, which are the same on both sides of the coordinate planes. So clusters depend on
// the shape: other triangles change the clusters nearby and no others, and a shape with mirror symmetry gets mirrored ones.
template <typename Graph>
class Disk_clusters
{
public:
  using Index = Dual_graph::Index;

  // `radius`: in units of the square root of the area. The graph and the centres must outlive the object.
  Disk_clusters(const Graph& graph, const Centres& centre, double radius)
    : m_graph(graph), m_centre(centre), m_radius(radius), m_distances(graph.number_of_nodes()), m_ring(seam_lengths_of_arcs(graph))
  {}

  // At most `largest_number`: the radius grows until there are few enough.
  Clusters operator()(Index largest_number, Execution& execution)
  {
    constexpr double growth = 1.25;
    sort_nodes_by_priority(execution.is_parallel());
    for (double radius = m_radius; !select_seeds(radius, largest_number, execution);)
      radius *= growth;
    return clusters();
  }

private:
  struct Place
  {
    std::uint64_t priority; // of the cell
    float offset;           // from the centre of the cell
    Index node;

    bool operator<(const Place& other) const
    {
      return std::tie(priority, offset, node) < std::tie(other.priority, other.offset, other.node);
    }
  };

  void sort_nodes_by_priority(bool is_parallel)
  {
    m_places.resize(m_graph.number_of_nodes());
    for_each_number(m_places.size(), is_parallel, [&](Index i) { m_places[i] = place(i); });
    sort_different(m_places, is_parallel, std::less<>());
  }

  Place place(Index node) const
  {
    const double cell_size = m_radius / 2; // smaller than a disk, larger than most faces
    // of 21 bits; no surface that is 1 in area gets as far in any sensible number of faces
    constexpr double largest_coordinate = (1 << 21) - 1;
    std::uint64_t cell = 0;
    double squared_offset = 0;
    for (const float coordinate : {m_centre[node].x(), m_centre[node].y(), m_centre[node].z()})
    {
      const double x = std::abs(coordinate) / cell_size;
      const double corner = std::floor((std::min)(x, largest_coordinate));
      cell = cell << 21 | static_cast<std::uint64_t>(corner);
      squared_offset += CGAL::square(x - corner - 0.5);
    }
    return {mixed(cell), static_cast<float>(squared_offset), node};
  }

  // A permutation of the numbers of 64 bits without any order, the finalizer of MurmurHash3.
  static std::uint64_t mixed(std::uint64_t bits)
  {
    bits = (bits ^ bits >> 33) * 0xff51afd7ed558ccd;
    bits = (bits ^ bits >> 33) * 0xc4ceb9fe1a85ec53;
    return bits ^ bits >> 33;
  }

  // Returns whether there are no more than `largest_number`.
  bool select_seeds(double radius, Index largest_number, Execution& execution)
  {
    std::fill(m_distances.begin(), m_distances.end(), infinity);
    m_seeds.clear();
    for (const Place& place : m_places)
    {
      if (m_distances[place.node] < infinity)
        continue;
      if (m_seeds.size() == largest_number)
        return false;
      execution.check();
      m_seeds.push_back(place.node);
      push_source(place.node);
      spread(m_graph.lengths(), static_cast<float>(radius), [](Index, Index) {});
    }
    return true;
  }

  // Every node to its nearest seed.
  Clusters clusters()
  {
    Clusters result;
    result.number = static_cast<Index>(m_seeds.size());
    result.of_node.assign(m_graph.number_of_nodes(), result.number);
    std::fill(m_distances.begin(), m_distances.end(), infinity);
    std::sort(m_seeds.begin(), m_seeds.end());
    for (Index s = 0; s < result.number; ++s)
    {
      push_source(m_seeds[s]);
      result.of_node[m_seeds[s]] = s;
    }
    std::vector<Index> before(m_graph.number_of_nodes(), 0); // on the shortest path to a node
    spread([this](Index arc) { return m_graph.seam_length(arc); }, infinity, [&](Index from, Index to) { before[to] = from; });
    choose_equal_paths(before);
    std::vector<Index> path;
    for (Index node = 0; node < before.size(); ++node)
    {
      Index i = node;
      for (; result.of_node[i] == result.number; i = before[i])
        path.push_back(i);
      for (Index on_path : path)
        result.of_node[on_path] = result.of_node[i];
      path.clear();
    }
    return result;
  }

  // Of equally short paths to a node, that over the nearest and lowest one: on a regular mesh there are many, and symmetric parts shall
  // have the same clusters.
  void choose_equal_paths(std::vector<Index>& before) const
  {
    const auto rank = [this](Index i) { return std::make_pair(m_distances[i], i); };
    for (Index from = 0; from < before.size(); ++from)
      for (Index arc : m_graph.arcs(from))
        if (const Index to = m_graph.target[arc];
            m_distances[from] < m_distances[to] && m_distances[from] + m_graph.seam_length(arc) == m_distances[to] &&
            rank(from) < rank(before[to]))
          before[to] = from;
  }

  void push_source(Index node)
  {
    m_distances[node] = 0;
    m_ring.push_source(node);
  }

  // Shortest paths from the sources, as far as they are shorter than those of earlier ones. Calls `step(from, to)` whenever a path
  // to a node is the shortest so far.
  template <typename Length, typename Step>
  void spread(Length length, float limit, Step step)
  {
    float* const distances = m_distances.data();
    m_ring.scan_all(
      [=](Index node) { return distances[node]; },
      [=](Index node, Ring::Offer* end)
      {
        for (Index arc : m_graph.arcs(node))
        {
          const Index neighbor = m_graph.target[arc];
          const float distance = distances[node] + static_cast<float>(length(arc));
          *end = {distance, neighbor, node};
          end += (distance < distances[neighbor]) & (distance <= limit);
        }
        return end;
      },
      [&, distances](const Ring::Offer& path)
      {
        distances[path.vertex] = path.distance;
        step(path.before, path.vertex);
      },
      [] {});
  }

  using Ring = Bucket_ring<Index, float>;
  static constexpr float infinity = (std::numeric_limits<float>::infinity)();

  const Graph& m_graph;
  const Centres& m_centre;
  double m_radius;
  std::vector<Place> m_places; // by priority
  std::vector<Index> m_seeds;
  std::vector<float> m_distances; // of every node to the nearest seed
  Ring m_ring;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_DISK_CLUSTERS_H
