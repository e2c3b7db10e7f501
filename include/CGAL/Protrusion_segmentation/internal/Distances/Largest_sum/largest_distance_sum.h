// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_SUM_LARGEST_DISTANCE_SUM_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_SUM_LARGEST_DISTANCE_SUM_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/Joint_sum_bounds.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/Local_sum_bounds.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The sum of eq. (1), in a fixed order.
inline double distance_sum(const std::vector<double>& distances)
{
  return std::accumulate(distances.begin(), distances.end(), 0.);
}

// The face with the largest sum of distances to all faces, eq. (1), the lowest face where several share
// it, by one distance computation per face: the reference, and the way for distances that are no metric.
template <typename Distances>
Indexed_surface::Index largest_distance_sum_of_all_pairs(const Indexed_surface& surface,
                                                         Distances& distances,
                                                         Execution& execution)
{
  using Index = Indexed_surface::Index;
  std::vector<double> from_face;
  Index best = 0;
  double largest = -1;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    execution.progress(static_cast<double>(f) / surface.number_of_faces());
    distances(f, from_face);
    const double sum = distance_sum(from_face);
    if (sum > largest)
    {
      largest = sum;
      best = f;
    }
  }
  return best;
}

// Whether distances are lengths of shortest paths and tell how these run.
template <typename Distances, typename = void>
struct Has_shortest_path_tree : std::false_type
{};
template <typename Distances>
struct Has_shortest_path_tree<Distances, std::void_t<decltype(std::declval<Distances&>().tree())>>
  : std::true_type
{};

// The same face for a metric, in a handful of distance computations.
//
// By the triangle inequality S(i) <= S(l) + N d(i, l), where S(i) is the sum for face i and N the number of
// faces. The smallest of these bounds over all faces l visited so far is kept for every face; the face with
// the largest bound is visited next, until no bound reaches the largest sum found.
//
// Where the distances are those of shortest paths, `Local_sum_bounds` lowers the bounds around each visited face, and
// `Joint_sum_bounds` that of each face that would be visited, which mostly rules it out and faces around it. Other
// distances are metrics only nearly, as that of the heat method: for them no further inequality is used.
//
// Since rounding may put a bound below the sum it bounds, bounds are enlarged by `m_rounding`: the relative
// errors of a path and of some sums, of up to N terms each, are below N times the machine's epsilon.
template <typename Distances>
class Largest_distance_sum
{
public:
  using Index = Indexed_surface::Index;

  Largest_distance_sum(const Indexed_surface& surface, Distances& distances, Execution& execution)
    : m_surface(surface),
      m_distances(distances),
      m_execution(execution),
      m_number_of_faces(surface.number_of_faces()),
      m_rounding(1 + 16. * m_number_of_faces * (std::numeric_limits<double>::epsilon)()),
      m_bounds(surface.number_of_faces(), (std::numeric_limits<double>::infinity)()),
      m_local_bounds(has_tree ? surface.number_of_faces() : 0, m_rounding),
      m_joint_bounds(surface.number_of_faces())
  {}

  // Visits up to `maximum_number_of_visits` faces; returns the best of them.
  Index operator()(std::size_t maximum_number_of_visits)
  {
    std::optional<Index> next;
    if (m_number_of_faces > 0)
      next = 0;
    for (std::size_t visits = 0; visits < maximum_number_of_visits && next; ++visits)
    {
      // how many there will be is not known; most surfaces need about ten
      m_execution.progress(static_cast<double>(visits) / static_cast<double>(visits + 20));
      visit(visits == visit_to_middle ? middle().value_or(*next) : *next);
      next = most_promising();
    }
    return m_best;
  }

  // The distances from the face that was returned, which leave the search.
  std::vector<double> take_distances_from_best() { return std::move(m_from_best); }

private:
  // Without it, some models take a tenth more visits.
  static constexpr std::size_t visit_to_middle = 2;
  // Before a visit as many bounds are sharpened as take a quarter of its time.
  static constexpr Index faces_per_sharpened_bound = 100;
  static constexpr Index least_sharpened_bounds = 16;

  static constexpr bool has_tree = Has_shortest_path_tree<Distances>::value;
  static constexpr double visited = -1; // in place of a bound

  // Of a block of faces the one with the largest bound. With blocks of 32 or 128 faces the search takes the same time.
  static constexpr Index faces_of_block = 64;
  struct Candidate
  {
    double bound;
    Index face;

    bool operator<(const Candidate& other) const
    {
      return bound != other.bound ? bound < other.bound : face > other.face;
    }
  };

  // The face in the middle of those visited before, if it was not visited itself. Its own sum is small, but most shortest
  // paths lead near to it.
  std::optional<Index> middle() const
  {
    if (m_joint_bounds.number_of_sources() > 0)
      if (const Index face = m_joint_bounds.middle(); m_bounds[face] != visited)
        return face;
    return std::nullopt;
  }

  void visit(Index face)
  {
    m_distances(face, m_from_face);
    const double sum = distance_sum(m_from_face);
    for_each_number(m_number_of_faces, m_execution.is_parallel(),
                    [&](Index f) {
                      m_bounds[f] = (std::min)(m_bounds[f],
                                               (sum + m_number_of_faces * m_from_face[f]) * m_rounding);
                    });
    m_bounds[face] = visited;
    if constexpr (has_tree)
      if (std::isfinite(sum) && !m_distances.tree().order.empty())
      {
        m_local_bounds.lower(m_distances, m_from_face, sum, (std::max)(m_largest, sum), m_bounds);
        m_joint_bounds.add(m_from_face);
      }
    if (sum > m_largest || (sum == m_largest && face < m_best))
    {
      m_best = face;
      m_largest = sum;
      std::swap(m_from_face, m_from_best);
    }
  }

  // Whether the sum of a face may exceed the largest one found. At that sum it can tie at most, which matters only
  // for a lower face.
  bool is_open(Index f) const
  {
    return m_bounds[f] > m_largest || (m_bounds[f] == m_largest && f < m_best);
  }

  // The face with the largest bound, the lowest one among equals; none if no sum can exceed the largest one found. Bounds
  // are sharpened from the largest one down, until the largest one is sharp or too much time has passed.
  std::optional<Index> most_promising()
  {
    m_candidates = {};
    for (Index begin = 0; begin < m_number_of_faces; begin += faces_of_block)
      add_best_of_block(begin);
    Index rest = m_number_of_faces / faces_per_sharpened_bound + least_sharpened_bounds;
    while (!m_candidates.empty())
    {
      const Index face = m_candidates.top().face;
      m_candidates.pop();
      if (is_open(face)) // else ruled out since
      {
        if (rest == 0 || !sharpen(face))
          return face;
        --rest;
      }
      add_best_of_block(face / faces_of_block * faces_of_block);
    }
    return std::nullopt;
  }

  // If any face of it is open.
  void add_best_of_block(Index begin)
  {
    const Index end = (std::min)(begin + faces_of_block, m_number_of_faces);
    const auto best = std::max_element(m_bounds.begin() + begin, m_bounds.begin() + end);
    const Index face = static_cast<Index>(best - m_bounds.begin());
    if (is_open(face))
      m_candidates.push({*best, face});
  }

  // Returns whether the bound was not sharp yet.
  bool sharpen(Index face)
  {
    const double bound = m_joint_bounds(face) * m_rounding;
    if (!(bound < m_bounds[face]))
      return false;
    m_bounds[face] = bound;
    if (bound < m_largest)
      rule_out_around(face);
    return true;
  }

  // By the triangle inequality the bound of a face bounds those of its neighbours, and so on, as long as they are ruled out.
  void rule_out_around(Index face)
  {
    m_ruled_out.assign(1, face);
    while (!m_ruled_out.empty())
    {
      const Index f = m_ruled_out.back();
      m_ruled_out.pop_back();
      for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
      {
        const Index g = m_surface.neighbor(c);
        if (g == Indexed_surface::no_face() || m_bounds[g] < m_largest)
          continue;
        const double bound = m_bounds[f] + m_number_of_faces * m_surface.arc_length(f, g) * m_rounding;
        if (bound < m_largest)
        {
          m_bounds[g] = bound;
          m_ruled_out.push_back(g);
        }
      }
    }
  }

  const Indexed_surface& m_surface;
  Distances& m_distances;
  Execution& m_execution;
  Index m_number_of_faces;
  double m_rounding;
  std::vector<double> m_bounds;
  Local_sum_bounds m_local_bounds;
  Joint_sum_bounds m_joint_bounds;
  std::priority_queue<Candidate> m_candidates; // one of each block with any
  std::vector<Index> m_ruled_out;
  std::vector<double> m_from_face, m_from_best;
  Index m_best = 0;
  double m_largest = -1;
};

// The face of eq. (1) for a metric, the same as of all pairs.
template <typename Distances>
Indexed_surface::Index largest_distance_sum(const Indexed_surface& surface,
                                            Distances& distances,
                                            Execution& execution)
{
  return Largest_distance_sum<Distances>(surface, distances, execution)(surface.number_of_faces());
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_SUM_LARGEST_DISTANCE_SUM_H
