// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Bucket_ring.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Dual_arcs.h>

#include <boost/range/adaptor/transformed.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// How the shortest paths from the last source run.
struct Shortest_path_tree
{
  // The faces as they were scanned. One that was scanned again is there again; its last place is behind the
  // last place of its parent, but where the way to the parent got shorter by less than the sum of both rounds off.
  std::vector<Indexed_surface::Index> order;
  // The face before a face on the path to it; for the source anything.
  std::vector<Indexed_surface::Index> parent;
};

// Single-source shortest paths on the face dual graph (Section III.B.2), by Dijkstra's algorithm with a `Bucket_ring` in
// place of the heap. Work arrays are kept between runs.
class Shortest_distances
{
public:
  using Index = Indexed_surface::Index;
  static constexpr double unreachable() { return (std::numeric_limits<double>::infinity)(); }

  explicit Shortest_distances(const Indexed_surface& surface) : Shortest_distances(Dual_arcs(surface)) {}
  explicit Shortest_distances(Dual_arcs arcs)
    : m_arcs(std::make_shared<const Dual_arcs>(std::move(arcs))), m_ring(lengths_of(*m_arcs))
  {}

  // The distances from `source`; faces farther than `bound` may be left unreachable.
  void operator()(Index source, std::vector<double>& all_distances, double bound = unreachable())
  {
    ++m_number_of_runs;
    all_distances.assign(m_arcs->number_of_faces(), unreachable());
    std::vector<Index>& order = m_tree.order;
    order.clear();
    order.reserve(all_distances.size() + all_distances.size() / 8); // more than the faces scanned again
    m_tree.parent.resize(all_distances.size());
    // addresses that stay in registers; those in vectors would be read again whenever an address was written
    double* const distances = all_distances.data();
    Index* const parent = m_tree.parent.data();
    const Dual_arcs::View arcs = m_arcs->view();

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
                    [] {});
    m_number_of_scanned_faces += order.size();
  }

  const Dual_arcs& arcs() const { return *m_arcs; }

  // of the last run
  const Shortest_path_tree& tree() const { return m_tree; }

  std::size_t number_of_runs() const { return m_number_of_runs; }
  // faces taken from the queue over all runs
  std::size_t number_of_scanned_faces() const { return m_number_of_scanned_faces; }

private:
  using Ring = Bucket_ring<Index>;

  static Arc_lengths lengths_of(const Dual_arcs& arcs)
  {
    Arc_lengths lengths;
    for (Index f = 0; f < arcs.number_of_faces(); ++f)
      lengths.add_vertex(arcs[f] | boost::adaptors::transformed([](const Dual_arcs::Arc& arc) { return arc.length(); }));
    return lengths;
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
  Ring m_ring;
  Shortest_path_tree m_tree;
  std::size_t m_number_of_runs = 0;
  std::size_t m_number_of_scanned_faces = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H
