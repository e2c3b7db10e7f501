// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "randomized_cuts.h"

#include "Face_distance_graph.h"
#include "Segment_network.h"
#include "decimation.h"
#include "hierarchical_cuts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace {

// In [0, 1); the distributions of the standard library differ from one to another.
double random_share(std::mt19937& random)
{
  return double(random()) / 4294967296.;
}

// Drawn with a probability in proportion to the weights.
std::size_t random_index(const std::vector<double>& weights, std::mt19937& random)
{
  double rest = random_share(random) * std::accumulate(weights.begin(), weights.end(), 0.);
  std::size_t i = 0;
  while (i + 1 < weights.size() && (rest -= weights[i]) >= 0)
    ++i;
  return i;
}

// A random face of a segment, the distances from it, and the faces in their order.
struct Place
{
  std::size_t face;
  std::vector<double> distances;
  std::vector<std::size_t> order;
};

// The cuts of one segment.
class Segment_cuts
{
public:
  Segment_cuts(const Segment_faces& segment, const Randomized_cuts_options& options, std::mt19937& random)
    : m_segment(segment),
      m_options(options),
      m_random(random)
  {}

  void make(const std::function<std::vector<double>(std::size_t face)>& distances_from)
  {
    for (std::size_t i = 0; i < m_options.places; ++i)
      add_place(distances_from);
    std::vector<Segment_network::Link> links;
    for (const Seam& seam : m_segment.seams)
      links.push_back({seam.a, seam.b, seam.cost});
    Segment_network network(m_segment.faces.size(), links);
    for (std::size_t i = 0; i < m_options.cuts; ++i)
      make_cut(network);
    count_uses();
  }

  // The most consistent cut: the one whose edges most of the cuts run through. Empty if there are none.
  std::vector<bool> most_consistent() const
  {
    const auto best = std::max_element(m_sides.begin(), m_sides.end(),
                                       [&](const std::vector<bool>& a, const std::vector<bool>& b)
                                       { return consistency(a) < consistency(b); });
    return best == m_sides.end() ? std::vector<bool>() : *best;
  }

private:
  static bool is_cut(const Seam& seam, const std::vector<bool>& side)
  {
    return side[seam.a] != side[seam.b];
  }

  // Mean share of the cuts that run through the edges of this one, by length.
  double consistency(const std::vector<bool>& side) const
  {
    double sum = 0, length = 0;
    for (std::size_t i = 0; i < m_segment.seams.size(); ++i)
      if (is_cut(m_segment.seams[i], side))
      {
        sum += m_shares[i] * m_segment.seams[i].length;
        length += m_segment.seams[i].length;
      }
    return length > 0 ? sum / length : 0;
  }

  void add_place(const std::function<std::vector<double>(std::size_t face)>& distances_from)
  {
    Place place;
    place.face = random_index(m_segment.areas, m_random);
    place.distances = distances_from(place.face);
    place.order.resize(m_segment.faces.size());
    std::iota(place.order.begin(), place.order.end(), std::size_t(0));
    std::sort(place.order.begin(), place.order.end(),
              [&](std::size_t a, std::size_t b) { return place.distances[a] < place.distances[b]; });
    m_places.push_back(std::move(place));
  }

  // The faces nearest to a place with a random share of the segment's area: no cut comes closer.
  std::vector<std::size_t> random_core(const Place& place)
  {
    const double low = m_options.least_share, high = m_options.largest_share;
    const double area = low * std::pow(high / low, random_share(m_random)) * m_segment.area;
    std::vector<std::size_t> core;
    double sum = 0;
    for (const std::size_t i : place.order)
    {
      if (!core.empty() && sum + m_segment.areas[i] > area)
        break;
      core.push_back(i);
      sum += m_segment.areas[i];
    }
    return core;
  }

  // Between two places: far ones are drawn more often.
  void make_cut(Segment_network& network)
  {
    const Place& first = m_places[m_random() % m_places.size()];
    std::vector<double> weights;
    for (const Place& place : m_places)
      weights.push_back(first.distances[place.face] * first.distances[place.face]);
    const Place& second = m_places[random_index(weights, m_random)];

    const std::vector<std::size_t> first_core = random_core(first);
    std::vector<std::size_t> second_core = random_core(second);
    std::vector<bool> is_first(m_segment.faces.size(), false);
    for (const std::size_t i : first_core)
      is_first[i] = true;
    second_core.erase(
      std::remove_if(second_core.begin(), second_core.end(), [&](std::size_t i) { return is_first[i]; }),
      second_core.end());
    if (!second_core.empty())
      m_sides.push_back(network.side_of(first_core, second_core));
  }

  void count_uses()
  {
    m_shares.assign(m_segment.seams.size(), 0.);
    for (const std::vector<bool>& side : m_sides)
      for (std::size_t i = 0; i < m_shares.size(); ++i)
        m_shares[i] += is_cut(m_segment.seams[i], side) ? 1 / double(m_sides.size()) : 0;
  }

  const Segment_faces& m_segment;
  const Randomized_cuts_options& m_options;
  std::mt19937& m_random;
  std::vector<Place> m_places;
  std::vector<std::vector<bool>> m_sides; // of each cut
  std::vector<double> m_shares;           // of the cuts, that run through each seam
};

} // namespace

Labels randomized_cuts_segmentation(const Mesh& mesh,
                                    std::size_t number_of_segments,
                                    unsigned int seed,
                                    const Randomized_cuts_options& options)
{
  const Mesh small = decimated(mesh, options.faces);
  const Face_distance_graph graph(small, [&](Halfedge h) { return centroid_distance(small, h); });
  const std::vector<Seam> seams = all_seams(small, options.exponent);
  const std::vector<double> areas = face_areas(small);
  std::mt19937 random(seed);

  const auto split_of = [&](const Labels& labels, std::size_t label) -> Split
  {
    const Segment_faces segment(seams, areas, labels, label);
    if (segment.faces.size() < options.least_faces)
      return {};
    Segment_cuts cuts(segment, options, random);
    cuts.make(
      [&](std::size_t face)
      {
        const std::vector<double> of_all = graph.distances_within(labels, segment.faces[face]);
        std::vector<double> distances;
        for (const std::size_t f : segment.faces)
          distances.push_back(of_all[f]);
        return distances;
      });
    const std::vector<bool> side = cuts.most_consistent();
    Split split;
    for (std::size_t i = 0; i < side.size(); ++i)
      if (side[i])
        split.faces.push_back(segment.faces[i]);
    if (!split.faces.empty())
      split.value = -normalized_cost(segment, side);
    return split;
  };
  return labels_from_decimated(mesh, small, split_best_first(small, number_of_segments, split_of));
}
