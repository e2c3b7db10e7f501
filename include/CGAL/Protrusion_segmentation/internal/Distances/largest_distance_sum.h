// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_DISTANCE_SUM_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_DISTANCE_SUM_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Local_sum_bounds.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The sum of eq. (1) in a fixed order.
inline double distance_sum(const std::vector<double>& distances)
{
  double sum = 0;
  for (double d : distances)
    sum += d;
  return sum;
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

template <typename Distances, typename = void>
struct Has_shortest_path_tree : std::false_type {};

template <typename Distances>
struct Has_shortest_path_tree<Distances, std::void_t<decltype(std::declval<Distances&>().tree())>>
  : std::true_type {};

// The same face for a metric, in a handful of distance computations.
//
// By the triangle inequality S(i) <= S(l) + N d(i, l), where S(i) is the sum for face i and N the number of
// faces. The smallest of these bounds over all faces l visited so far is kept for every face; the face with
// the largest bound is visited next, until no bound reaches the largest sum found. Where the distances are
// those of shortest paths, Local_sum_bounds sharpens the bounds around each visited face.
//
// Since rounding may put a bound below the sum it bounds, bounds are enlarged by `m_rounding`: the relative
// errors of a path and of a sum, of up to N terms each, are below N times the machine's epsilon.
template <typename Distances>
class Largest_distance_sum
{
public:
  using Index = Indexed_surface::Index;

  Largest_distance_sum(const Indexed_surface& surface, Distances& distances, Execution& execution)
    : m_number_of_faces(surface.number_of_faces()),
      m_rounding(1 + 8 * m_number_of_faces * (std::numeric_limits<double>::epsilon)()),
      m_distances(distances),
      m_execution(execution),
      m_bounds(surface.number_of_faces(), (std::numeric_limits<double>::infinity)()),
      m_is_visited(surface.number_of_faces(), false),
      m_local_bounds(surface)
  {}

  // Visits up to `maximum_number_of_visits` faces; returns the best of them.
  Index operator()(std::size_t maximum_number_of_visits)
  {
    Index next = 0;
    for (std::size_t i = 0; i < maximum_number_of_visits && next < m_number_of_faces; ++i)
    {
      // how many visits there will be is not known; most surfaces need some dozen
      m_execution.progress(static_cast<double>(i) / static_cast<double>(i + 50));
      visit(next);
      next = widest();
    }
    m_bound = next < m_number_of_faces ? m_bounds[next] : m_largest;
    return m_best;
  }

  // By how much another face may do better, relative to the sum of the face that was returned; 0 if the
  // search came to its end.
  double gap() const { return m_bound > m_largest ? m_bound / m_largest - 1 : 0; }

private:
  void visit(Index face)
  {
    m_distances(face, m_from_face);
    m_is_visited[face] = true;
    const double sum = distance_sum(m_from_face);
    if (sum > m_largest || (sum == m_largest && face < m_best))
    {
      m_largest = sum;
      m_best = face;
    }
    for (Index f = 0; f < m_number_of_faces; ++f)
      m_bounds[f] = (std::min)(m_bounds[f], (sum + m_number_of_faces * m_from_face[f]) * m_rounding);
    if constexpr (Has_shortest_path_tree<Distances>::value)
      if (std::isfinite(sum) && !m_distances.tree().order.empty())
        m_local_bounds.lower(m_distances.tree(), m_from_face, m_largest, m_rounding,
                             [this](Index f) { return !m_is_visited[f]; }, m_bounds);
  }

  // The face that may have the largest sum, the lowest one among equals; none if no sum can exceed the
  // largest one found. At that bound a face can tie at most, which matters only if it is a lower one.
  Index widest() const
  {
    Index result = m_number_of_faces;
    double bound = m_largest;
    for (Index f = 0; f < m_number_of_faces; ++f)
      if (m_bounds[f] >= bound && !m_is_visited[f] &&
          (m_bounds[f] > bound || (result == m_number_of_faces && f < m_best)))
      {
        bound = m_bounds[f];
        result = f;
      }
    return result;
  }

  Index m_number_of_faces;
  double m_rounding;
  Distances& m_distances;
  Execution& m_execution;
  std::vector<double> m_bounds;
  std::vector<bool> m_is_visited;
  Local_sum_bounds m_local_bounds;
  std::vector<double> m_from_face;
  Index m_best = 0;
  double m_largest = -1;
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
