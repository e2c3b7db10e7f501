// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_SUM_LOCAL_SUM_BOUNDS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_SUM_LOCAL_SUM_BOUNDS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Upper bounds of the sums of eq. (1) for the faces around a visited one, far closer than the triangle
// inequality and at the cost of a small neighbourhood.
//
// Take the shortest path tree of the visited face and the faces nearest to it, the ball. Every face j hangs
// on the last face p(j) of the ball on its path, itself if it lies in the ball. From a face i of the ball
// one can go to p(j) inside the ball and on along the tree, so
//   d(i, j) <= d_ball(i, p(j)) + d(c, j) - d(c, p(j)),
// where c is the visited face and d_ball the distance inside the ball. Summed over all j,
//   S(i) <= sum over p of w(p) d_ball(i, p) + D,
// with w(p) the number of faces that hang on p and D the sum of d(c, j) - d(c, p(j)). Paths to far faces leave
// the ball in nearly the same places wherever in its middle they begin, so the bound is nearly sharp there.
// It needs one run of Dijkstra's algorithm in the ball alone. The tree of this run bounds the other faces of the ball: a
// face k beside i comes nearer to all that lies beyond k, and moves away by at most d(i, k) from the rest.
class Local_sum_bounds
{
public:
  using Index = Indexed_surface::Index;

  // Every computed bound is multiplied by `rounding`.
  Local_sum_bounds(Index number_of_faces, double rounding)
    : m_rounding(rounding),
      m_number_in_ball(number_of_faces, Indexed_surface::no_face()),
      m_holder(number_of_faces)
  {}

  // Lowers the bounds around the source of the last run of `shortest_distances`, where they reach `largest`, the largest sum
  // found so far. `distances` are those from the source, all finite, and `sum` is their sum.
  template <typename ShortestDistances>
  void lower(const ShortestDistances& shortest_distances,
             const std::vector<double>& distances,
             double sum,
             double largest,
             std::vector<double>& bounds)
  {
    const Index n = static_cast<Index>(distances.size());
    const Index ball_size = (std::max)(n / ball_share, (std::min)(n / 2, least_ball_size));
    if (ball_size == 0)
      return;
    collect_ball(shortest_distances.tree(), ball_size);
    const double radius = distances[m_ball.back()];
    const auto is_no_candidate = [&](Index i)
    { return bounds[m_ball[i]] < largest || distances[m_ball[i]] >= radius * share_of_radius; };
    std::vector<Index> candidates(ball_size); // by their numbers in the ball
    std::iota(candidates.begin(), candidates.end(), Index(0));
    const auto remove = [&]()
    {
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_no_candidate),
                       candidates.end());
    };

    remove();
    if (!candidates.empty())
    {
      hang_up_faces(shortest_distances.tree(), distances, sum);
      // differences of distances up to twice the radius are added up n times
      m_margin = 8. * n * radius * (std::numeric_limits<double>::epsilon)();
      Shortest_distances in_ball(Dual_arcs(shortest_distances.arcs(), m_ball, m_number_in_ball));
      for (Index run = 0; run < n / ball_size * relative_work && !candidates.empty(); ++run)
      {
        const auto widest = std::max_element(candidates.begin(), candidates.end(),
                                             [&](Index i, Index k)
                                             { return bounds[m_ball[i]] < bounds[m_ball[k]]; });
        find_sums(*widest, in_ball);
        for (Index i = 0; i < ball_size; ++i)
          bounds[m_ball[i]] = (std::min)(bounds[m_ball[i]], m_sums[i] * m_rounding);
        candidates.erase(widest);
        remove();
      }
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
      if (Index& number = m_number_in_ball[tree.order[i]];
          number == Indexed_surface::no_face()) // else scanned again
      {
        number = static_cast<Index>(m_ball.size());
        m_ball.push_back(tree.order[i]);
      }
  }

  // The weights w(p), and D.
  void hang_up_faces(const Shortest_path_tree& tree, const std::vector<double>& distances, double sum)
  {
    m_holder.assign(m_holder.size(), Indexed_surface::no_face());
    for (Index f : tree.order)
    {
      const Index number = m_number_in_ball[f];
      m_holder[f] = number != Indexed_surface::no_face() ? number : m_holder[tree.parent[f]];
    }
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

  // The bounds of all faces of the ball by the paths from one of them, first by the triangle inequality, then by the tree:
  // a step away from the source comes nearer to the weight below and goes away from the rest.
  void find_sums(Index source, Shortest_distances& in_ball)
  {
    const double n = static_cast<double>(m_holder.size());
    in_ball(source, m_from_source);
    const double sum = std::inner_product(m_weights.begin(), m_weights.end(), m_from_source.begin(),
                                          m_hanging_sum);
    m_sums.resize(m_ball.size());
    for (std::size_t i = 0; i < m_sums.size(); ++i)
      m_sums[i] = sum + n * m_from_source[i];
    if (!find_weights_below(in_ball.tree()))
      return;
    for (auto place = m_children_first.rbegin(); place != m_children_first.rend(); ++place)
    {
      const Index face = *place, parent = in_ball.tree().parent[face];
      const double step = m_from_source[face] - m_from_source[parent];
      m_sums[face] = m_sums[parent] + step * (n - 2 * m_weights_below[face]) + m_margin;
    }
  }

  // The faces of the tree but the source, children before their parents, and the weight of each with all beyond it. Returns
  // false if rounding put a parent before its child, which is rare.
  bool find_weights_below(const Shortest_path_tree& tree)
  {
    m_children_first.clear();
    m_is_found.assign(m_ball.size(), false);
    m_weights_below = m_weights;
    for (std::size_t k = tree.order.size() - 1; k > 0; --k)
    {
      const Index face = tree.order[k], parent = tree.parent[face];
      if (m_is_found[face])
        continue;
      if (m_is_found[parent])
        return false;
      m_is_found[face] = true;
      m_children_first.push_back(face);
      m_weights_below[parent] += m_weights_below[face];
    }
    return true;
  }

  double m_rounding;
  std::vector<Index> m_number_in_ball; // of every face
  std::vector<Index> m_holder;         // p(j) of every face j by number in the ball

  std::vector<Index> m_ball;
  std::vector<double> m_weights; // w(p) by number in the ball, as all below
  double m_hanging_sum = 0;      // D
  double m_margin = 0;           // for rounding, of a step along the tree

  std::vector<double> m_from_source;
  std::vector<double> m_sums;
  std::vector<double> m_weights_below;
  std::vector<Index> m_children_first;
  std::vector<bool> m_is_found;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_SUM_LOCAL_SUM_BOUNDS_H
