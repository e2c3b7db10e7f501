// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LOCAL_SUM_BOUNDS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LOCAL_SUM_BOUNDS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/sum_of_terms.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

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

  explicit Local_sum_bounds(Index number_of_faces)
    : m_number_in_ball(number_of_faces, Indexed_surface::no_face()),
      m_holder(number_of_faces)
  {}

  // Lowers the bounds around the source of `tree` and `distances`, whose sum is `sum`, where they reach `largest`, the
  // largest sum found so far. Every computed bound is multiplied by `rounding`. All faces must have been reached.
  void lower(const Dual_arcs& arcs,
             const Shortest_path_tree& tree,
             const std::vector<double>& distances,
             double sum,
             double largest,
             double rounding,
             std::vector<double>& bounds)
  {
    const Index n = static_cast<Index>(distances.size());
    const Index ball_size = (std::max)(n / ball_share, (std::min)(n / 2, least_ball_size));
    if (ball_size == 0)
      return;
    collect_ball(tree, ball_size);
    const double radius = distances[m_ball.back()];
    const auto is_in_middle = [&](Index f) { return distances[f] < radius * share_of_radius; };
    if (std::any_of(m_ball.begin(), m_ball.end(), [&](Index f) { return bounds[f] >= largest && is_in_middle(f); }))
    {
      hang_up_faces(tree, distances, sum);
      // of a step, for differences of rounded distances up to twice the radius, times n, are added up
      m_margin = 8. * n * radius * (std::numeric_limits<double>::epsilon)();
      lower_in_ball(Dual_arcs(arcs, m_ball, m_number_in_ball), n / ball_size * relative_work, rounding,
                    [&](Index i) { return m_bounds_in_ball[i] >= largest && is_in_middle(m_ball[i]); }, bounds);
    }
    for (Index f : m_ball)
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

  void collect_ball(const Shortest_path_tree& tree, Index size)
  {
    m_ball.clear();
    for (std::size_t i = 0; m_ball.size() < size; ++i)
    {
      Index& number = m_number_in_ball[tree.order[i]];
      if (number != Indexed_surface::no_face()) // scanned again
        continue;
      number = static_cast<Index>(m_ball.size());
      m_ball.push_back(tree.order[i]);
    }
  }

  // The weights w(p), and D: by as much as what p hangs by is nearer the sum is smaller.
  void hang_up_faces(const Shortest_path_tree& tree, const std::vector<double>& distances, double sum)
  {
    m_holder.assign(m_holder.size(), Indexed_surface::no_face());
    for (Index f : tree.order)
      m_holder[f] = is_in_ball(f) ? m_number_in_ball[f] : m_holder[tree.parent[f]];
    m_weights.assign(m_ball.size(), 0);
    for (Index f = 0; f < distances.size(); ++f)
      m_weights[find_holder(f, tree)] += 1;
    m_hanging_sum = sum;
    for (Index i = 0; i < m_ball.size(); ++i)
      m_hanging_sum -= m_weights[i] * distances[m_ball[i]];
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

  // Again and again for the candidate with the largest bound, by its number in the ball; its new bound is handed on to the
  // whole ball.
  template <typename IsCandidate>
  void lower_in_ball(Dual_arcs arcs,
                     Index number_of_runs,
                     double rounding,
                     IsCandidate is_candidate,
                     std::vector<double>& bounds)
  {
    Shortest_distances distances_in_ball(std::move(arcs));
    std::vector<double> distances, sums;
    std::vector<Index> open;
    m_bounds_in_ball.clear();
    for (Index i = 0; i < m_ball.size(); ++i)
    {
      m_bounds_in_ball.push_back(bounds[m_ball[i]]);
      if (is_candidate(i))
        open.push_back(i);
    }
    for (Index run = 0; run < number_of_runs && !open.empty(); ++run)
    {
      const auto widest_place = std::max_element(
        open.begin(), open.end(), [&](Index i, Index k) { return m_bounds_in_ball[i] < m_bounds_in_ball[k]; });
      const Index widest = *widest_place;
      open.erase(widest_place);
      distances_in_ball(widest, distances);
      const double sum = m_hanging_sum + sum_of_terms(m_ball.size(), [&](std::size_t i) { return m_weights[i] * distances[i]; });
      hand_on(sum, distances_in_ball.tree(), distances, sums);
      for (Index i = 0; i < m_ball.size(); ++i)
        m_bounds_in_ball[i] = (std::min)(m_bounds_in_ball[i], sums[i] * rounding);
      open.erase(std::remove_if(open.begin(), open.end(), [&](Index i) { return !is_candidate(i); }), open.end());
    }
    for (Index i = 0; i < m_ball.size(); ++i)
      bounds[m_ball[i]] = m_bounds_in_ball[i];
  }

  // The sums of the lengths of paths along the tree from all faces of the ball, and on to what hangs on them, where
  // `sum` is that of the source: a step away from it comes nearer to the weight below and goes away from the rest.
  void hand_on(double sum,
               const Shortest_path_tree& tree,
               const std::vector<double>& distances,
               std::vector<double>& sums)
  {
    const double n = static_cast<double>(m_number_in_ball.size());
    sums.resize(distances.size());
    for (std::size_t i = 0; i < distances.size(); ++i)
      sums[i] = sum + n * distances[i];
    if (tree.order.empty())
      return;
    collect_last_places(tree);
    for (auto place = m_last_places.rbegin(); place != m_last_places.rend(); ++place)
    {
      const Index face = *place, parent = tree.parent[face];
      sums[face] = sums[parent] + (distances[face] - distances[parent]) * (n - 2 * m_weights_below[face]) + m_margin;
    }
  }

  // The faces of a tree but the source, parents behind their children, and the weights below each.
  void collect_last_places(const Shortest_path_tree& tree)
  {
    m_last_places.clear();
    m_is_collected.assign(m_weights.size(), 0);
    m_weights_below = m_weights;
    bool are_parents_behind = true;
    for (std::size_t k = tree.order.size() - 1; k > 0; --k)
    {
      const Index face = tree.order[k];
      if (m_is_collected[face])
        continue;
      m_is_collected[face] = 1;
      m_last_places.push_back(face);
      m_weights_below[tree.parent[face]] += m_weights_below[face];
      are_parents_behind = are_parents_behind && !m_is_collected[tree.parent[face]];
    }
    if (!are_parents_behind)
      sort_by_depth(tree);
  }

  // The deepest first; rare enough to take the time to walk to the source from every face.
  void sort_by_depth(const Shortest_path_tree& tree)
  {
    const Index source = tree.order.front();
    std::vector<Index> depth(m_is_collected.size());
    for (Index face : m_last_places)
      for (Index f = face; f != source; f = tree.parent[f])
        ++depth[face];
    std::stable_sort(m_last_places.begin(), m_last_places.end(), [&](Index f, Index g) { return depth[f] > depth[g]; });
    m_weights_below = m_weights;
    for (Index face : m_last_places)
      m_weights_below[tree.parent[face]] += m_weights_below[face];
  }

  std::vector<Index> m_ball;           // nearest first
  std::vector<Index> m_number_in_ball; // of every face
  std::vector<Index> m_holder;         // p(j) of every face j by number in the ball
  std::vector<double> m_weights;       // w(p) by number in the ball
  double m_hanging_sum = 0;            // D
  double m_margin = 0;
  std::vector<double> m_weights_below; // with the weights of all that is beyond on the tree
  std::vector<Index> m_last_places;    // by number in the ball
  std::vector<char> m_is_collected;
  std::vector<double> m_bounds_in_ball; // of sums, by number in the ball
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LOCAL_SUM_BOUNDS_H
