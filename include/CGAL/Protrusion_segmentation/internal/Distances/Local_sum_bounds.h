// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LOCAL_SUM_BOUNDS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LOCAL_SUM_BOUNDS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Sums_in_ball.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Faces around one, as they were scanned, and new upper bounds of their sums.
struct Bounds_in_ball
{
  std::vector<Indexed_surface::Index> faces;
  std::vector<double> bounds;

  void clear()
  {
    faces.clear();
    bounds.clear();
  }
};

// Upper bounds of the sums of eq. (1) for the faces around a visited one, far closer than the triangle
// inequality and at the cost of a small neighbourhood.
//
// Take the shortest path tree of the visited face and the faces nearest to it, the ball. Every face j hangs
// on the last face p(j) of the ball on its path, itself if it lies in the ball. From a face i of the ball
// one can go to p(j) inside the ball and on along the tree, so
//   d(i, j) <= d_ball(i, p(j)) + d(c, j) - d(c, p(j)),
// where c is the visited face and d_ball the distance inside the ball. Summed over all j,
//   S(i) <= sum over p of w(p) d_ball(i, p) + D,
// with w(p) the number of faces that hang on p and D the sum of what they hang by. Paths to far faces leave
// the ball in nearly the same places wherever in its middle they begin, so the bound is nearly sharp there;
// and it needs one run of Dijkstra's algorithm in the ball alone. The tree of this run hands the bound on: a face k
// beside i comes nearer to all that lies beyond k, and no farther than by d(i, k) from the rest.
class Local_sum_bounds
{
public:
  using Index = Indexed_surface::Index;

  explicit Local_sum_bounds(Index number_of_faces, bool is_parallel = false)
    : m_is_parallel(is_parallel),
      m_number_in_ball(number_of_faces, Indexed_surface::no_face()),
      m_holder(number_of_faces)
  {}

  // Lowers the bounds around the source of `tree` and `distances`, whose sum is `sum`, where they reach `largest`, the
  // largest sum found so far. `bound_of(f)`: what is known before. Every computed bound is multiplied by `rounding`. All faces
  // must have been reached.
  template <typename BoundOf>
  void lower(const Dual_arcs& arcs,
             const Shortest_path_tree& tree,
             const std::vector<double>& distances,
             double sum,
             double largest,
             double rounding,
             BoundOf bound_of,
             Bounds_in_ball& result)
  {
    const Index n = static_cast<Index>(distances.size());
    const Index ball_size = (std::max)(n / ball_share, (std::min)(n / 2, least_ball_size));
    if (ball_size == 0)
      return;
    collect_ball(tree, ball_size, result.faces);
    for (Index f : result.faces)
      result.bounds.push_back(bound_of(f));
    const double radius = distances[result.faces.back()];
    const auto is_candidate = [&](Index i)
    { return result.bounds[i] >= largest && distances[result.faces[i]] < radius * share_of_radius; };
    std::vector<Index> candidates;
    for (Index i = 0; i < ball_size; ++i)
      if (is_candidate(i))
        candidates.push_back(i);
    if (!candidates.empty())
    {
      hang_up_faces(tree, distances, sum, result.faces);
      // of a step, for differences of rounded distances up to twice the radius, times n, are added up
      m_hanging.margin = 8. * n * radius * (std::numeric_limits<double>::epsilon)();
      lower_in_ball(Dual_arcs(arcs, result.faces, m_number_in_ball), n / ball_size * relative_work, rounding, is_candidate,
                    std::move(candidates), result.bounds);
    }
    for (Index f : result.faces)
      m_number_in_ball[f] = Indexed_surface::no_face();
  }

private:
  // The ball is a 32nd of the surface, but not small. On parts of Princeton models one twice as large takes 2 % fewer
  // visits and more time, above all where there are many faces; with 256 faces at least there are 8 % more visits.
  static constexpr Index ball_share = 32;
  static constexpr Index least_ball_size = 512;
  // Bounds are computed in the middle of the ball, for the others the path out of it is too short ...
  static constexpr double share_of_radius = 0.5;
  // ... and for no more faces than twice the work of the full run pays for.
  static constexpr Index relative_work = 2;
  // In a large ball two runs at once, whatever the number of threads, so that bounds do not depend on it: 6 % more runs than
  // one after the other, and on a million faces 2 %. In a small one they take less time than to share them.
  static constexpr Index large_ball_size = 4096;

  void collect_ball(const Shortest_path_tree& tree, Index size, std::vector<Index>& ball)
  {
    for (std::size_t i = 0; ball.size() < size; ++i)
    {
      Index& number = m_number_in_ball[tree.order[i]];
      if (number != Indexed_surface::no_face()) // scanned again
        continue;
      number = static_cast<Index>(ball.size());
      ball.push_back(tree.order[i]);
    }
  }

  // The weights w(p), and D: by as much as what p hangs by is nearer the sum is smaller.
  void hang_up_faces(const Shortest_path_tree& tree,
                     const std::vector<double>& distances,
                     double sum,
                     const std::vector<Index>& ball)
  {
    m_holder.assign(m_holder.size(), Indexed_surface::no_face());
    for (Index f : tree.order)
      m_holder[f] = is_in_ball(f) ? m_number_in_ball[f] : m_holder[tree.parent[f]];
    m_hanging.number = static_cast<double>(distances.size());
    m_hanging.weights.assign(ball.size(), 0);
    for (Index f = 0; f < distances.size(); ++f)
      m_hanging.weights[find_holder(f, tree)] += 1;
    m_hanging.sum = sum;
    for (Index i = 0; i < ball.size(); ++i)
      m_hanging.sum -= m_hanging.weights[i] * distances[ball[i]];
  }

  // By its number in the ball. A face may have been scanned before its parent: then what it hangs on was not known yet.
  Index find_holder(Index face, const Shortest_path_tree& tree)
  {
    Index known = face;
    while (m_holder[known] == Indexed_surface::no_face())
      known = tree.parent[known];
    return m_holder[face] = m_holder[known];
  }

  bool is_in_ball(Index f) const { return m_number_in_ball[f] != Indexed_surface::no_face(); }

  // Again and again for the candidates with the largest bounds, by their numbers in the ball; new bounds are handed on to
  // the whole ball.
  template <typename IsCandidate>
  void lower_in_ball(Dual_arcs arcs,
                     Index number_of_runs,
                     double rounding,
                     IsCandidate is_candidate,
                     std::vector<Index> candidates,
                     std::vector<double>& bounds) const
  {
    const std::size_t runs_at_once = bounds.size() >= large_ball_size ? 2 : 1;
    std::vector<Sums_in_ball> sums_in_ball(runs_at_once, Sums_in_ball(Shortest_distances(std::move(arcs)), m_hanging));
    for (std::size_t run = 0; run < number_of_runs && !candidates.empty(); run += runs_at_once)
    {
      const std::vector<Index> widest = take_widest(candidates, runs_at_once, bounds);
      for_each_index(widest.size(), m_is_parallel && runs_at_once > 1, [&](std::size_t k) { sums_in_ball[k](widest[k]); });
      for (std::size_t k = 0; k < widest.size(); ++k)
        for (Index i = 0; i < bounds.size(); ++i)
          bounds[i] = (std::min)(bounds[i], sums_in_ball[k].sums()[i] * rounding);
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(), [&](Index i) { return !is_candidate(i); }),
                       candidates.end());
    }
  }

  // Takes up to `number` of the candidates out.
  static std::vector<Index> take_widest(std::vector<Index>& candidates,
                                        std::size_t number,
                                        const std::vector<double>& bounds)
  {
    std::vector<Index> result;
    while (result.size() < number && !candidates.empty())
    {
      const auto widest = std::max_element(candidates.begin(), candidates.end(),
                                           [&](Index i, Index k) { return bounds[i] < bounds[k]; });
      result.push_back(*widest);
      candidates.erase(widest);
    }
    return result;
  }

  bool m_is_parallel;
  std::vector<Index> m_number_in_ball; // of every face
  std::vector<Index> m_holder;         // p(j) of every face j by number in the ball
  Hanging_faces m_hanging;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LOCAL_SUM_BOUNDS_H
