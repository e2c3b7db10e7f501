// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// How the shortest paths from the last source run.
struct Shortest_path_tree
{
  // The faces as they were scanned. One that was scanned again is there again; its last place is behind the
  // last place of its parent. Empty if Boost's algorithm did the work.
  std::vector<Indexed_surface::Index> order;
  // The face before a face on the path to it; for the source anything.
  std::vector<Indexed_surface::Index> parent;
};

// Single-source shortest paths on the face dual graph (Section III.B.2), with the same result to the last
// bit as Dijkstra's algorithm of the Boost Graph Library.
//
// A ring of buckets, each as wide as the mean arc, takes the place of the heap. Inside a bucket a face may
// be scanned again when a shorter path to it turns up; since rounding is monotone, the distances still are
// the smallest over all paths. On Princeton models 1.06 scans per face and 3 times the speed of Boost's
// 4-ary heap. Where the longest arc is too long for the ring, Boost's algorithm does the work.
//
// All work arrays are kept between runs.
class Shortest_distances
{
public:
  using Index = Indexed_surface::Index;
  using Graph = Indexed_surface::Dual_graph;
  static constexpr double unreachable() { return (std::numeric_limits<double>::infinity)(); }

  explicit Shortest_distances(const Indexed_surface& surface) : Shortest_distances(surface.dual_graph()) {}

  explicit Shortest_distances(Graph graph) : m_graph(std::make_shared<const Graph>(std::move(graph)))
  {
    double sum = 0, longest = 0;
    for (const auto arc : boost::make_iterator_range(edges(*m_graph)))
    {
      sum += (*m_graph)[arc].length;
      longest = (std::max)(longest, (*m_graph)[arc].length);
    }
    if (sum > 0)
    {
      const double mean = sum / static_cast<double>(num_edges(*m_graph));
      m_buckets_per_unit = 1 / mean;
      // An arc ends at most longest / mean + 1 buckets further, and one more where rounding moves its ends
      // to different sides of a bucket's limit. The ring must be longer than that.
      if (longest <= mean * max_buckets)
        m_buckets.resize(static_cast<std::size_t>(longest / mean) + 3);
    }
  }

  // The distances from `source`; faces farther than `bound` may be left unreachable.
  void operator()(Index source, std::vector<double>& distances, double bound = unreachable())
  {
    ++m_number_of_runs;
    distances.assign(num_vertices(*m_graph), unreachable());
    m_tree.order.clear();
    if (m_buckets.empty())
      run_boost(source, distances);
    else
      run_buckets(source, distances, bound);
  }

  // of the last run
  const Shortest_path_tree& tree() const { return m_tree; }

  std::size_t number_of_runs() const { return m_number_of_runs; }
  // faces taken from the queue over all runs
  std::size_t number_of_scanned_faces() const { return m_number_of_scanned_faces; }

private:
  // A longer ring would cost more to walk than the heap; meshes with arcs a thousand times their mean are
  // needles and rare.
  static constexpr std::size_t max_buckets = 1024;

  void run_boost(Index source, std::vector<double>& distances)
  {
    boost::dijkstra_shortest_paths_no_color_map(
      *m_graph, source,
      boost::weight_map(get(&Indexed_surface::Arc::length, *m_graph))
        .distance_map(boost::make_iterator_property_map(distances.begin(),
                                                        get(boost::vertex_index, *m_graph))));
    m_number_of_scanned_faces += distances.size();
  }

  std::size_t bucket(double distance) const
  {
    return static_cast<std::size_t>(distance * m_buckets_per_unit);
  }

  // The place in the ring of the bucket `ahead` of the one at `place`, less than a round; a division by the
  // size of the ring would take a fifth of the whole time.
  std::size_t place_ahead(std::size_t place, std::size_t ahead) const
  {
    return place + ahead < m_buckets.size() ? place + ahead : place + ahead - m_buckets.size();
  }

  void run_buckets(Index source, std::vector<double>& distances, double bound)
  {
    m_tree.parent.resize(distances.size());
    m_tree.order.reserve(distances.size() + distances.size() / 8); // more than the faces scanned again
    distances[source] = 0;
    m_buckets[0].push_back(source);
    std::size_t pending = 1;
    for (std::size_t current = 0, place = 0; pending > 0; ++current, place = place_ahead(place, 1))
    {
      std::vector<Index>& queue = m_buckets[place];
      for (std::size_t i = 0; i < queue.size(); ++i) // the queue grows while it is read
        if (bucket(distances[queue[i]]) == current)  // else: scanned before, from a nearer bucket
          pending += scan(queue[i], current, place, distances, bound);
      pending -= queue.size();
      queue.clear();
    }
    m_number_of_scanned_faces += m_tree.order.size();
  }

  // Offers the paths over `face` to its neighbours; returns how many took one.
  std::size_t scan(Index face,
                   std::size_t current,
                   std::size_t place,
                   std::vector<double>& distances,
                   double bound)
  {
    m_tree.order.push_back(face);
    std::size_t taken = 0;
    for (const auto arc : boost::make_iterator_range(out_edges(face, *m_graph)))
    {
      const double distance = distances[face] + (*m_graph)[arc].length;
      const Index neighbor = target(arc, *m_graph);
      if (distance < distances[neighbor] && distance <= bound)
      {
        distances[neighbor] = distance;
        m_tree.parent[neighbor] = face;
        m_buckets[place_ahead(place, bucket(distance) - current)].push_back(neighbor);
        ++taken;
      }
    }
    return taken;
  }

  std::shared_ptr<const Graph> m_graph; // shared by copies, one for each thread
  double m_buckets_per_unit = 0;
  std::vector<std::vector<Index>> m_buckets;
  Shortest_path_tree m_tree;
  std::size_t m_number_of_runs = 0;
  std::size_t m_number_of_scanned_faces = 0;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H
