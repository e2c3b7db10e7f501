// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_LARGEST_DISTANCE_SUM_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_LARGEST_DISTANCE_SUM_H

#include <CGAL/Protrusion_segmentation/Surface_part.h>

#include <algorithm>
#include <cstddef>
#include <limits>
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
Surface_part::Index largest_distance_sum_of_all_pairs(const Surface_part& part, Distances& distances)
{
  using Index = Surface_part::Index;
  std::vector<double> from_face;
  Index best = 0;
  double largest = -1;
  for (Index f = 0; f < part.number_of_faces(); ++f)
  {
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
// the largest bound is visited next, until no bound reaches the largest sum found. Since rounding may put a
// bound below the sum it bounds, bounds are enlarged by `rounding`: the relative error of a sum of N terms
// is below N times the machine's epsilon.
template <typename Distances>
Surface_part::Index largest_distance_sum(const Surface_part& part, Distances& distances)
{
  using Index = Surface_part::Index;
  const Index n = part.number_of_faces();
  const double rounding = 1 + 4 * n * (std::numeric_limits<double>::epsilon)();
  std::vector<double> bounds(n, (std::numeric_limits<double>::infinity)());
  std::vector<bool> visited(n, false);
  std::vector<double> from_face;
  Index best = 0;
  double largest = -1;
  for (Index next = 0; next < n;)
  {
    distances(next, from_face);
    visited[next] = true;
    const double sum = distance_sum(from_face);
    if (sum > largest || (sum == largest && next < best))
    {
      largest = sum;
      best = next;
    }
    Index widest = n;
    double widest_bound = largest;
    for (Index f = 0; f < n; ++f)
    {
      bounds[f] = (std::min)(bounds[f], (sum + n * from_face[f]) * rounding);
      // at the bound `largest` a face can tie at most, which matters only if it is a lower one
      if (!visited[f] &&
          (bounds[f] > widest_bound || (bounds[f] == widest_bound && widest == n && f < best)))
      {
        widest_bound = bounds[f];
        widest = f;
      }
    }
    next = widest;
  }
  return best;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_LARGEST_DISTANCE_SUM_H
