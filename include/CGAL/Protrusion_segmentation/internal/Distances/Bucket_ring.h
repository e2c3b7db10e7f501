// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_BUCKET_RING_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_BUCKET_RING_H

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// What a ring must know of the arcs of a graph.
struct Arc_lengths
{
  double sum = 0;
  double longest = 0;
  std::size_t number = 0;
  std::size_t most_of_a_vertex = 0;

  template <typename Lengths>
  void add_vertex(const Lengths& lengths)
  {
    std::size_t of_this_vertex = 0;
    for (const double length : lengths)
    {
      sum += length;
      longest = (std::max)(longest, length);
      ++of_this_vertex;
    }
    number += of_this_vertex;
    most_of_a_vertex = (std::max)(most_of_a_vertex, of_this_vertex);
  }

  double mean() const { return number > 0 ? sum / static_cast<double>(number) : 0; }
};

// A ring of buckets in place of the heap of Dijkstra's algorithm, each as wide as the mean arc, or wider if one arc is very
// long. Inside a bucket a vertex may be scanned again when a shorter path to it is found. The distances are the same to
// the last bit as with a heap: the smallest over all paths, for rounding is monotone. On Princeton models there are 1.06
// scans per face.
//
// Some vertices are scanned at once, in two passes: the first writes the paths that are shorter than those known, without a
// branch, the second accepts those that still are. This avoids mispredicted branches and takes half the time of
// accepting each path as it is found.
template <typename Vertex, typename Distance = double>
class Bucket_ring
{
public:
  struct Offer
  {
    Distance distance;
    Vertex vertex;
    Vertex before; // on the path
  };

  // The lengths must be finite.
  explicit Bucket_ring(const Arc_lengths& arcs)
  {
    const double width = (std::max)(arcs.mean(), arcs.longest / most_buckets);
    make_buckets(width > 0 ? width : 1, arcs);
  }

  // A vertex whose distance is 0, before all others.
  void push_source(const Vertex& vertex)
  {
    m_buckets[0].push_back(vertex);
    ++m_number_of_sources;
  }

  // In the order of the buckets:
  // - `offer(vertex, place)` writes the paths over a vertex that are shorter than those known from `place` on and returns the
  //   place behind them,
  // - `accept(offer)` is called where the offer still is shorter than `distance_of(vertex)`, the least that is known,
  // - `leave_bucket()` is called when the distances of all vertices whose paths were offered up to then are final.
  template <typename DistanceOf, typename OfferPaths, typename Accept, typename LeaveBucket>
  void scan_all(DistanceOf distance_of, OfferPaths offer, Accept accept, LeaveBucket leave_bucket)
  {
    // in registers, which members would not be
    const double buckets_per_unit = m_buckets_per_unit;
    const std::size_t mask = m_buckets.size() - 1, at_once = m_vertices_at_once;
    std::vector<Vertex>* const buckets = m_buckets.data();
    Offer* const offers = m_offers.data();
    const auto bucket = [=](Distance d) { return static_cast<std::size_t>(static_cast<double>(d) * buckets_per_unit); };

    std::size_t pending = std::exchange(m_number_of_sources, 0);
    for (std::size_t current = 0; pending > 0; ++current)
    {
      std::vector<Vertex>& queue = buckets[current & mask];
      for (std::size_t i = 0; i < queue.size();) // the queue grows while it is read
      {
        Offer* end_of_offers = offers;
        for (const std::size_t end = (std::min)(queue.size(), i + at_once); i < end; ++i)
          if (bucket(distance_of(queue[i])) == current) // else: scanned before, from a nearer bucket
            end_of_offers = offer(queue[i], end_of_offers);
        for (const Offer* path = offers; path != end_of_offers; ++path)
          if (path->distance < distance_of(path->vertex))
          {
            accept(*path);
            buckets[bucket(path->distance) & mask].push_back(path->vertex);
            ++pending;
          }
      }
      pending -= queue.size();
      queue.clear();
      leave_bucket();
    }
  }

private:
  void make_buckets(double width, const Arc_lengths& arcs)
  {
    m_buckets_per_unit = 1 / width;
    // An arc ends at most longest / width + 1 buckets further, and one more where rounding moves its ends
    // to different sides of a bucket's limit. The ring must be longer than that. A power of two spares a division.
    std::size_t size = 4;
    while (size < static_cast<std::size_t>(arcs.longest / width) + 3)
      size *= 2;
    m_buckets.resize(size);
    const std::size_t most = (std::max)(arcs.most_of_a_vertex, std::size_t(1));
    m_vertices_at_once = (std::min)(most_vertices_at_once, (std::max)(most_offers / most, std::size_t(1)));
    m_offers.resize(m_vertices_at_once * most + 1);
  }

  // A longer ring would cost more to walk than a heap. Arcs a thousand times their mean are rare.
  static constexpr double most_buckets = 1024;
  // From 16 to 64 the paper's method takes the same time, with 8 a tenth more. Of vertices with many arcs fewer are scanned
  // at once.
  static constexpr std::size_t most_vertices_at_once = 32;
  static constexpr std::size_t most_offers = 1024;

  double m_buckets_per_unit = 0;
  std::vector<std::vector<Vertex>> m_buckets; // as many as a power of two
  std::vector<Offer> m_offers;                // of the vertices that are scanned at once, and one that does not stay
  std::size_t m_vertices_at_once = 0;
  std::size_t m_number_of_sources = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_BUCKET_RING_H
