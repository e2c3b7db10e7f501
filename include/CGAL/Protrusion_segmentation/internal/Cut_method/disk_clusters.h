// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISK_CLUSTERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISK_CLUSTERS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Distance_queue.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/coarsen_graph.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Divides a connected graph into clusters by a Poisson disk sampling: seeds that are farther from each other than a
// radius, so many that no node is farther from all of them, and every node goes to the seed that is nearest when ways
// across concave seams are longer. Clusters are connected.
//
// Which nodes become seeds is decided by the places of the nodes, in the canonical frame of the surface: in the order of
// random numbers that belong to the cells of a grid, the same on both sides of the planes of the axes. So it
// depends on the shape: moved vertices or other triangles change the clusters nearby and no others, and a shape with
// mirror symmetry gets mirrored clusters.
class Disk_clusters
{
public:
  using Index = Weighted_dual_graph::Index;

  // The graph must outlive the object.
  explicit Disk_clusters(const Weighted_dual_graph& graph) : m_graph(graph), m_distances(graph.number_of_nodes()) {}

  // No more than `largest_number`: the radius is enlarged until there are few enough. Of the graph only lengths and centres
  // matter.
  void select_seeds(Index largest_number, Execution& execution)
  {
    constexpr double growth = 1.25;
    sort_nodes_by_priority();
    for (double radius = disk_radius; !try_radius(radius, largest_number, execution);)
      radius *= growth;
  }

  // Every node to its nearest seed. To be called once, after the seeds were selected.
  Clusters clusters()
  {
    Clusters result;
    result.number = static_cast<Index>(m_seeds.size());
    result.of_node.resize(m_graph.number_of_nodes());
    std::fill(m_distances.begin(), m_distances.end(), infinity);
    std::sort(m_seeds.begin(), m_seeds.end());
    for (Index s = 0; s < m_seeds.size(); ++s)
    {
      offer(m_seeds[s], 0);
      result.of_node[m_seeds[s]] = s;
    }
    spread(m_graph.seam_lengths(), infinity, [&](Index from, Index to) { result.of_node[to] = result.of_node[from]; });
    return result;
  }

private:
  // In units of the square root of the area: some two thousand clusters. The Rand index error on the development models of
  // the Princeton benchmark is .086, .089 and .086 with disks of this size in three random orders, .087 to .090 with a
  // radius of .02 to .026, and .085 to .087 with one of .018, which takes a third longer.
  static constexpr double disk_radius = 0.022;

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

  void sort_nodes_by_priority()
  {
    m_places.reserve(m_graph.number_of_nodes());
    for (Index i = 0; i < m_graph.number_of_nodes(); ++i)
      m_places.push_back(place(i));
    std::sort(m_places.begin(), m_places.end());
  }

  Place place(Index node) const
  {
    constexpr double cell_size = disk_radius / 2; // smaller than a disk, larger than most faces
    std::uint64_t cell = 0;
    double squared_offset = 0;
    const auto& centre = m_graph.centre[node];
    for (const float coordinate : {centre.x(), centre.y(), centre.z()})
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

  // Selects the seeds; returns whether there are no more than `largest_number`.
  bool try_radius(double radius, Index largest_number, Execution& execution)
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
      offer(place.node, 0);
      spread(m_graph.lengths(), static_cast<float>(radius), [](Index, Index) {});
    }
    return true;
  }

  void offer(Index node, float distance)
  {
    m_distances[node] = distance;
    m_queue.push(node, distance);
  }

  // Dijkstra's algorithm from the nodes that were offered, as far as they are nearer than earlier ones. Calls
  // `step(from, to)` whenever a way to a node is the shortest so far.
  template <typename Length, typename Step>
  void spread(Length length, float limit, Step step)
  {
    while (!m_queue.empty())
    {
      const auto [node, distance] = m_queue.pop();
      if (distance > m_distances[node])
        continue;
      for (Index arc : m_graph.arcs(node))
      {
        const Index neighbor = m_graph.target[arc];
        const float beyond = distance + static_cast<float>(length(arc));
        if (!(beyond < m_distances[neighbor] && beyond <= limit))
          continue;
        offer(neighbor, beyond);
        step(node, neighbor);
      }
    }
  }

  // what 21 bits hold; no surface that is 1 in area gets as far in any sensible number of faces
  static constexpr double largest_coordinate = (1 << 21) - 1;

  static constexpr float infinity = (std::numeric_limits<float>::infinity)();

  const Weighted_dual_graph& m_graph;
  std::vector<Place> m_places;    // by priority
  std::vector<Index> m_seeds;
  std::vector<float> m_distances; // of every node to the nearest seed
  Distance_queue m_queue;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_DISK_CLUSTERS_H
