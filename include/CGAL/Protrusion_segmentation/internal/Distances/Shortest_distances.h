// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SHORTEST_DISTANCES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Bucket_ring.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/prefetch.h>

#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
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

// The face dual graph as shortest paths read it: what is known of an arc lies in one place.
class Dual_arcs
{
public:
  using Index = Indexed_surface::Index;

  // 12 bytes, without a gap between the target and the length.
  class Arc
  {
  public:
    Arc(Index target, double length) : m_target(target) { std::memcpy(m_length, &length, sizeof(length)); }
    Index target() const { return m_target; }
    double length() const
    {
      double length;
      std::memcpy(&length, m_length, sizeof(length));
      return length;
    }

  private:
    Index m_target;
    Index m_length[2];
  };

  explicit Dual_arcs(const Indexed_surface& surface)
  {
    reserve(surface.number_of_faces(), surface.number_of_corners());
    for (Index f = 0; f < surface.number_of_faces(); ++f)
    {
      const Indexed_surface::Point_3 centroid = surface.centroid(f);
      for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
        if (const Index g = surface.neighbor(c); g != Indexed_surface::no_face())
          m_arcs.emplace_back(g, std::sqrt(squared_distance(centroid, surface.centroid(g))));
      m_first.push_back(static_cast<Index>(m_arcs.size()));
    }
  }

  // The arcs between some faces, where `numbers` has the place of each among them, or else `no_face()`.
  Dual_arcs(const Dual_arcs& all, const std::vector<Index>& faces, const std::vector<Index>& numbers)
  {
    reserve(faces.size(), 3 * faces.size());
    for (const Index face : faces)
    {
      for (const Arc& arc : all[face])
        if (const Index number = numbers[arc.target()]; number != Indexed_surface::no_face())
          m_arcs.emplace_back(number, arc.length());
      m_first.push_back(static_cast<Index>(m_arcs.size()));
    }
  }

  std::size_t number_of_faces() const { return m_first.size() - 1; }
  boost::iterator_range<const Arc*> operator[](Index face) const { return view()[face]; }

  // To be copied, where the addresses of the arrays are to be known.
  class View
  {
  public:
    View(const Index* first, const Arc* arcs) : m_first(first), m_arcs(arcs) {}
    boost::iterator_range<const Arc*> operator[](Index face) const
    {
      return {m_arcs + m_first[face], m_arcs + m_first[face + 1]};
    }

  private:
    const Index* m_first;
    const Arc* m_arcs;
  };
  View view() const { return {m_first.data(), m_arcs.data()}; }

  // The same as a graph of Boost's.
  Indexed_surface::Dual_graph graph() const
  {
    std::vector<Index> sources, targets;
    std::vector<Indexed_surface::Arc> properties;
    for (Index f = 0; f < number_of_faces(); ++f)
      for (const Arc& arc : (*this)[f])
      {
        sources.push_back(f);
        targets.push_back(arc.target());
        properties.push_back({arc.length()});
      }
    return Indexed_surface::Dual_graph(boost::construct_inplace_from_sources_and_targets, sources, targets, properties,
                                       static_cast<Index>(number_of_faces()));
  }

private:
  void reserve(std::size_t number_of_faces, std::size_t number_of_arcs)
  {
    m_first.reserve(number_of_faces + 1);
    m_first.push_back(0);
    m_arcs.reserve(number_of_arcs);
  }

  std::vector<Index> m_first; // of every face, and the end
  std::vector<Arc> m_arcs;
};

// Single-source shortest paths on the face dual graph (Section III.B.2), with the same result to the last
// bit as Dijkstra's algorithm of the Boost Graph Library.
//
// A `Bucket_ring` takes the place of the heap; where the longest arc is too long for it, Boost's algorithm does the
// work. `bucket_shortest_paths()` is the same for any graph; this one knows the tree of paths and bounds.
//
// All work arrays are kept between runs.
class Shortest_distances
{
public:
  using Index = Indexed_surface::Index;
  using Graph = Indexed_surface::Dual_graph;
  static constexpr double unreachable() { return (std::numeric_limits<double>::infinity)(); }

  explicit Shortest_distances(const Indexed_surface& surface) : Shortest_distances(Dual_arcs(surface)) {}

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
    else
      run_buckets(source, distances, bound);
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

  void run_buckets(Index source, std::vector<double>& all_distances, double bound)
  {
    std::vector<Index>& order = m_tree.order;
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
                    [] {},
                    [=](Index face)
                    {
                      prefetch(&distances[face]);
                      prefetch(arcs[face].begin());
                    });
    m_number_of_scanned_faces += order.size();
  }

  // Every path over `face` to a neighbour is written, but stays only if it is shorter.
  static Ring::Offer* offer_paths(Index face,
                                  boost::iterator_range<const Dual_arcs::Arc*> arcs,
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
