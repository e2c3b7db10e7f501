// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SUMS_IN_BALL_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SUMS_IN_BALL_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/sum_of_terms.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// What all faces of a surface hang on: faces of a ball, by their numbers in it.
struct Hanging_faces
{
  double number = 0;           // of all faces
  std::vector<double> weights; // w(p), how many hang on a face of the ball
  double sum = 0;              // D, of what they hang by
  double margin = 0;           // for what rounding takes off a step along a path
};

// Upper bounds of the sums of eq. (1) for all faces of a ball, by a run of Dijkstra's algorithm in the ball from one of them;
// see `Local_sum_bounds`. Copies can run at the same time.
class Sums_in_ball
{
public:
  using Index = Indexed_surface::Index;

  // `hanging` must outlive the object.
  Sums_in_ball(Shortest_distances distances, const Hanging_faces& hanging)
    : m_distances(std::move(distances)), m_hanging(hanging)
  {}

  void operator()(Index source)
  {
    m_distances(source, m_from_source);
    const std::vector<double>& weights = m_hanging.weights;
    hand_on(m_hanging.sum + sum_of_terms(weights.size(), [&](std::size_t i) { return weights[i] * m_from_source[i]; }));
  }

  // of the last run, by number in the ball
  const std::vector<double>& sums() const { return m_sums; }

private:
  // The sums of the lengths of paths along the tree from all faces of the ball, and on to what hangs on them, where
  // `sum` is that of the source: a step away from it comes nearer to the weight below and goes away from the rest.
  void hand_on(double sum)
  {
    const double n = m_hanging.number;
    m_sums.resize(m_from_source.size());
    for (std::size_t i = 0; i < m_sums.size(); ++i)
      m_sums[i] = sum + n * m_from_source[i];
    const Shortest_path_tree& tree = m_distances.tree();
    if (tree.order.empty())
      return;
    collect_last_places(tree);
    for (auto place = m_last_places.rbegin(); place != m_last_places.rend(); ++place)
    {
      const Index face = *place, parent = tree.parent[face];
      const double step = m_from_source[face] - m_from_source[parent];
      m_sums[face] = m_sums[parent] + step * (n - 2 * m_weights_below[face]) + m_hanging.margin;
    }
  }

  // The faces of the tree but the source, parents behind their children, and the weights below each.
  void collect_last_places(const Shortest_path_tree& tree)
  {
    m_last_places.clear();
    m_is_collected.assign(m_from_source.size(), 0);
    m_weights_below = m_hanging.weights;
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
    m_weights_below = m_hanging.weights;
    for (Index face : m_last_places)
      m_weights_below[tree.parent[face]] += m_weights_below[face];
  }

  Shortest_distances m_distances;
  const Hanging_faces& m_hanging;
  std::vector<double> m_from_source;
  std::vector<double> m_sums;
  std::vector<double> m_weights_below; // with the weights of all that is beyond on the tree
  std::vector<Index> m_last_places;    // by number in the ball
  std::vector<char> m_is_collected;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SUMS_IN_BALL_H
