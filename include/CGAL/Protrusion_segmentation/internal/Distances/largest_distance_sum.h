// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_DISTANCE_SUM_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_DISTANCE_SUM_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Face_visitor.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Joint_sum_bounds.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

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

// The same face for a metric, in a handful of distance computations.
//
// By the triangle inequality S(i) <= S(l) + N d(i, l), where S(i) is the sum for face i and N the number of
// faces. The smallest of these bounds over all faces l visited so far is kept for every face; the face with
// the largest bound is visited next, until no bound reaches the largest sum found.
//
// Another face with a large bound, far from that one, is visited at the same time: on 97 Princeton models there are 23 % fewer
// rounds, 5 % more visits, and a third fewer bounds to be sharpened. With any number of threads, since visits may be limited.
//
// Where the distances are those of shortest paths, Local_sum_bounds sharpens the bounds around each visited face, and
// Joint_sum_bounds that of each face that would be visited, which mostly rules it out and faces around it. Other
// distances are metrics only nearly, as that of the heat method: for them nothing is built on inequalities that are
// not needed.
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
      m_number_of_faces(surface.number_of_faces()),
      m_rounding(1 + 16. * m_number_of_faces * (std::numeric_limits<double>::epsilon)()),
      m_execution(execution),
      m_visits_at_once(has_tree && m_number_of_faces >= least_faces_for_two ? 2 : 1),
      m_bounds(surface.number_of_faces(), (std::numeric_limits<double>::infinity)()),
      m_sharpened_with(surface.number_of_faces(), 0),
      m_joint_bounds(surface.number_of_faces())
  {
    m_visitors.emplace_back(distances, m_number_of_faces, m_rounding, execution.is_parallel());
    if constexpr (has_tree)
      if (execution.is_parallel() && m_visits_at_once > 1)
      {
        m_other_distances.emplace(distances);
        m_visitors.emplace_back(*m_other_distances, m_number_of_faces, m_rounding, true);
      }
  }

  // Visits up to `maximum_number_of_visits` faces; returns the best of them.
  Index operator()(std::size_t maximum_number_of_visits)
  {
    constexpr std::size_t round_of_middle = 2;
    std::vector<Index> next = {0};
    for (std::size_t round = 0; m_number_of_visits < maximum_number_of_visits && !next.empty(); ++round)
    {
      if (round == round_of_middle)
        go_to_middle(next);
      next.resize((std::min)(next.size(), maximum_number_of_visits - m_number_of_visits));
      visit(next);
      next = most_promising();
    }
    m_bound = next.empty() ? m_largest : m_bounds[next.front()];
    return m_best;
  }

  // For as many of the visits a copy of the distances was used.
  std::size_t number_of_visits_by_copy() const { return m_number_of_visits_by_copy; }

  // By how much another face may do better, relative to the sum of the face that was returned; 0 if the
  // search came to its end.
  double gap() const { return m_bound > m_largest ? m_bound / m_largest - 1 : 0; }

  // The distances from the face that was returned, which leave the search.
  std::vector<double> take_distances_from_best() { return std::move(m_from_best); }

private:
  // Before a visit as many bounds are sharpened as take half the time of it.
  static constexpr Index faces_per_sharpened_bound = 50;
  static constexpr Index least_sharpened_bounds = 16;

  static constexpr bool has_tree = Face_visitor<Distances>::has_tree;
  // Where a visit takes less time than to wake a thread up, faces are visited one by one. With 1 in place of it two threads take
  // as long on Princeton models, and there are 6 % more runs for a face, with 8192 they take longer.
  static constexpr Index least_faces_for_two = 4096;
  // Of faces that are visited at the same time, relative to the longest distance from the first face of all. With .05 there are
  // 2 % more visits and 1 % fewer rounds, with .2 1 % fewer visits and 2 % more rounds.
  static constexpr double least_separation = 0.1;

  // Of a block of faces the one with the largest bound, when it was put into a heap. With blocks of 32 or 128 faces it takes
  // the same time.
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

  // At the same time, each by what is known before.
  void visit(const std::vector<Index>& faces)
  {
    m_visited.resize(faces.size());
    for_each_index(faces.size(), m_execution.is_parallel() && faces.size() > 1,
                   [&](std::size_t i)
                   {
                     tell_progress(m_number_of_visits + i);
                     m_visitors[i % m_visitors.size()](faces[i], m_bounds, m_largest, m_visited[i]);
                   });
    if (m_other_distances)
      m_number_of_visits_by_copy += faces.size() - 1;
    for (Visited_face& face : m_visited)
      take_into_account(face);
  }

  // How many visits there will be is not known; most surfaces need about ten.
  void tell_progress(std::size_t number_of_visits)
  {
    m_execution.progress(static_cast<double>(number_of_visits) / static_cast<double>(number_of_visits + 20));
  }

  void take_into_account(Visited_face& visit)
  {
    if (m_number_of_visits++ == 0)
      m_longest = visit.of_face.longest;
    lower_bounds(visit);
    const double sum = visit.of_face.sum;
    if (sum > m_largest || (sum == m_largest && visit.face < m_best))
    {
      m_best = visit.face;
      std::swap(visit.distances, m_from_best);
    }
    m_largest = (std::max)(m_largest, sum);
  }

  void lower_bounds(const Visited_face& visit)
  {
    for_each_block(m_number_of_faces, m_execution.is_parallel(),
                   [&](std::size_t begin, std::size_t end, std::size_t)
                   {
                     for (Index f = static_cast<Index>(begin); f < end; ++f)
                       m_bounds[f] = (std::min)(m_bounds[f], visit.bound(f, m_rounding));
                   });
    for (std::size_t i = 0; i < visit.around.faces.size(); ++i)
    {
      double& bound = m_bounds[visit.around.faces[i]];
      bound = (std::min)(bound, visit.around.bounds[i]);
    }
    m_bounds[visit.face] = visited;
    if (visit.has_paths)
      m_joint_bounds.add(visit.distances, visit.of_face.longest);
  }

  bool is_visited(Index face) const { return m_bounds[face] == visited; }

  // The face in the middle of those visited so far takes the place of the first one, unless there are no joint bounds. Its own
  // sum is small, but most shortest paths lead near to it.
  void go_to_middle(std::vector<Index>& next) const
  {
    if (m_joint_bounds.number_of_sources() == 0)
      return;
    const Index middle = m_joint_bounds.middle();
    if (is_visited(middle))
      return;
    next.front() = middle;
    if (next.back() == middle)
      next.resize(1);
  }

  // Whether the sum of a face may exceed the largest one found. At that sum it can tie at most, which matters only
  // for a lower face.
  bool is_open(Index f) const
  {
    return m_bounds[f] > m_largest || (m_bounds[f] == m_largest && f < m_best);
  }

  // The face with the largest bound, the lowest one among equals, and another one far from it; none if no sum can exceed the
  // largest one found. Bounds are sharpened from the largest one down, until the largest one is sharp or too much time has
  // passed.
  std::vector<Index> most_promising()
  {
    m_candidates = {};
    for (Index begin = 0; begin < m_number_of_faces; begin += faces_of_block)
      add_best_of_block(begin);
    Index rest = m_number_of_faces / faces_per_sharpened_bound + least_sharpened_bounds;
    std::vector<Index> result;
    while (!m_candidates.empty() && result.size() < m_visits_at_once)
    {
      const Candidate next = m_candidates.top();
      m_candidates.pop();
      const bool is_of_now = next.bound == m_bounds[next.face] && is_open(next.face);
      if (is_of_now && !result.empty() && m_surface.arc_length(result.front(), next.face) < least_separation * m_longest)
        continue; // nor is the rest of its block far
      if (is_of_now && (is_sharpened(next.face) || rest == 0))
      {
        result.push_back(next.face);
        continue;
      }
      if (is_of_now)
      {
        sharpen(next.face);
        --rest;
      }
      add_best_of_block(next.face / faces_of_block * faces_of_block);
    }
    return result;
  }

  // If any face of it is open.
  void add_best_of_block(Index begin)
  {
    const Index end = (std::min)(begin + faces_of_block, m_number_of_faces);
    Candidate best = {m_largest, m_number_of_faces};
    for (Index f = begin; f < end; ++f)
      if (m_bounds[f] >= best.bound && is_open(f) && best < Candidate{m_bounds[f], f})
        best = {m_bounds[f], f};
    if (best.face < m_number_of_faces)
      m_candidates.push(best);
  }

  bool is_sharpened(Index f) const { return m_sharpened_with[f] == m_joint_bounds.number_of_sources(); }

  void sharpen(Index face)
  {
    m_sharpened_with[face] = static_cast<unsigned char>(m_joint_bounds.number_of_sources());
    m_bounds[face] = (std::min)(m_bounds[face], m_joint_bounds(face) * m_rounding);
    if (m_bounds[face] < m_largest)
      rule_out_around(face);
  }

  // The triangle inequality hands the bound of a face that is out on from neighbour to neighbour, as long as it rules
  // them out.
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
  Index m_number_of_faces;
  double m_rounding;
  Execution& m_execution;
  std::size_t m_visits_at_once; // at most
  std::optional<Distances> m_other_distances; // a copy, for another thread
  std::deque<Face_visitor<Distances>> m_visitors;
  std::vector<Visited_face> m_visited; // in this round
  std::size_t m_number_of_visits = 0, m_number_of_visits_by_copy = 0;
  std::vector<double> m_bounds;
  std::vector<unsigned char> m_sharpened_with; // how many sources
  Joint_sum_bounds m_joint_bounds;
  std::priority_queue<Candidate> m_candidates; // one of each block with any
  std::vector<Index> m_ruled_out;
  std::vector<double> m_from_best;
  Index m_best = 0;
  double m_largest = -1;
  double m_longest = 0; // from the first face
  double m_bound = -1;
};

// The face of eq. (1) for a metric, the same as of all pairs.
template <typename Distances>
Indexed_surface::Index largest_distance_sum(const Indexed_surface& surface,
                                            Distances& distances,
                                            Execution& execution)
{
  return Largest_distance_sum<Distances>(surface, distances, execution)(surface.number_of_faces());
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_DISTANCE_SUM_H
