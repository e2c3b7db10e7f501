// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Bucket_ring.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Dual_arcs.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/prefetch.h>

#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/adaptor/transformed.hpp>

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
  // last place of its parent, but where the way to the parent got shorter by less than the sum of both rounds off. Empty if
  // Boost's algorithm did the work.
  std::vector<Indexed_surface::Index> order;
  // The face before a face on the path to it; for the source anything.
  std::vector<Indexed_surface::Index> parent;
};

// Single-source shortest paths on the face dual graph (Section III.B.2), with the same result to the last
// bit as Dijkstra's algorithm of the Boost Graph Library.
//
// A `Bucket_ring` takes the place of the heap; where the longest arc is too long for it, Boost's algorithm does the
// work.
//
// All work arrays are kept between runs.
class Shortest_distances
{
public:
  using Index = Indexed_surface::Index;
  using Graph = Indexed_surface::Dual_graph;
  static constexpr double unreachable() { return (std::numeric_limits<double>::infinity)(); }

  // `is_parallel`: whether several threads prepare it
  explicit Shortest_distances(const Indexed_surface& surface, bool is_parallel = false)
    : Shortest_distances(Dual_arcs(surface, is_parallel))
  {}

  explicit Shortest_distances(Dual_arcs arcs)
    : m_arcs(std::make_shared<const Dual_arcs>(std::move(arcs))), m_ring(ring_for(*m_arcs))
  {
    if (!m_ring.is_usable())
      m_graph = std::make_shared<const Graph>(m_arcs->graph());
  }

  // The distances from `source`; faces farther than `bound` may be left unreachable.
  void operator()(Index source, std::vector<double>& distances, double bound = unreachable())
  {
    ++m_number_of_runs;
    distances.assign(m_arcs->number_of_faces(), unreachable());
    m_tree.order.clear();
    if (m_graph)
      run_boost(source, distances);
    else if (m_arcs->has_three_places())
      run_buckets(m_arcs->three_places(), source, distances, bound);
    else
      run_buckets(m_arcs->any_places(), source, distances, bound);
  }

  const Dual_arcs& arcs() const { return *m_arcs; }

  // of the last run
  const Shortest_path_tree& tree() const { return m_tree; }

  std::size_t number_of_runs() const { return m_number_of_runs; }
  // faces taken from the queue over all runs
  std::size_t number_of_scanned_faces() const { return m_number_of_scanned_faces; }

private:
  using Ring = Bucket_ring<Index>;

  static Ring ring_for(const Dual_arcs& arcs)
  {
    Arc_lengths lengths;
    for (Index f = 0; f < arcs.number_of_faces(); ++f)
      lengths.add_vertex(arcs[f] | boost::adaptors::transformed([](const Dual_arcs::Arc& arc) { return arc.length(); }));
    return Ring(lengths);
  }

  void run_boost(Index source, std::vector<double>& distances)
  {
    boost::dijkstra_shortest_paths_no_color_map(
      *m_graph, source,
      boost::weight_map(get(&Indexed_surface::Arc::length, *m_graph))
        .distance_map(boost::make_iterator_property_map(distances.begin(),
                                                        get(boost::vertex_index, *m_graph))));
    m_number_of_scanned_faces += distances.size();
  }

  static constexpr std::size_t faces_in_caches = 400000;

  // Reads memory before it is needed. Distances of neighbours lie near those of the face: to ask for them takes 13 % off the
  // paper's method with a million faces, but adds a fiftieth where all is in the caches.
  template <typename Arcs>
  struct Prefetch
  {
    const double* distances;
    Arcs arcs;
    bool is_large;

    void vertex(Index face) const
    {
      prefetch(&distances[face]);
      prefetch(arcs[face].begin());
      prefetch(arcs[face].end());
    }
    void neighbors(Index face) const
    {
      if (is_large)
        for (const Dual_arcs::Arc& arc : arcs[face])
          prefetch(&distances[arc.target()]);
    }
  };

  template <typename Arcs>
  void run_buckets(Arcs arcs, Index source, std::vector<double>& all_distances, double bound)
  {
    std::vector<Index>& order = m_tree.order;
    order.reserve(all_distances.size() + all_distances.size() / 8); // more than the faces scanned again
    m_tree.parent.resize(all_distances.size());
    // addresses that stay in registers; those in vectors would be read again whenever an address was written
    double* const distances = all_distances.data();
    Index* const parent = m_tree.parent.data();

    distances[source] = 0;
    m_ring.push_source(source);
    m_ring.scan_all([=](Index face) { return distances[face]; },
                    [=, &order](Index face, Ring::Offer* end)
                    {
                      order.push_back(face);
                      return offer_paths(face, arcs[face], distances, bound, end);
                    },
                    [=](const Ring::Offer& path)
                    {
                      distances[path.vertex] = path.distance;
                      parent[path.vertex] = path.before;
                    },
                    [] {}, Prefetch<Arcs>{distances, arcs, all_distances.size() > faces_in_caches});
    m_number_of_scanned_faces += order.size();
  }

  // Every path over `face` to a neighbour is written, but stays only if it is shorter.
  template <typename Arcs>
  static Ring::Offer* offer_paths(Index face,
                                  const Arcs& arcs,
                                  const double* distances,
                                  double bound,
                                  Ring::Offer* end)
  {
    const double to_face = distances[face];
    for (const Dual_arcs::Arc& arc : arcs)
    {
      const double distance = to_face + arc.length();
      *end = {distance, arc.target(), face};
      end += (distance < distances[arc.target()]) & (distance <= bound);
    }
    return end;
  }

  std::shared_ptr<const Dual_arcs> m_arcs; // shared by copies, one for each thread
  std::shared_ptr<const Graph> m_graph;    // where Boost's algorithm does the work
  Ring m_ring;
  Shortest_path_tree m_tree;
  std::size_t m_number_of_runs = 0;
  std::size_t m_number_of_scanned_faces = 0;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H
