// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_FACE_VISITOR_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_FACE_VISITOR_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Local_sum_bounds.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Of the distances from a face.
struct Sum_and_longest
{
  double sum = 0; // of eq. (1), in a fixed order
  double longest = 0;
};

// Both in one go: while one addition waits for the one before, the processor compares.
inline Sum_and_longest sum_and_longest(const std::vector<double>& distances)
{
  Sum_and_longest result;
  for (double d : distances)
  {
    result.sum += d;
    result.longest = (std::max)(result.longest, d);
  }
  return result;
}

inline double distance_sum(const std::vector<double>& distances)
{
  return sum_and_longest(distances).sum;
}

template <typename Distances, typename = void>
struct Has_shortest_path_tree : std::false_type {};

template <typename Distances>
struct Has_shortest_path_tree<Distances, std::void_t<decltype(std::declval<Distances&>().tree())>>
  : std::true_type {};

// In place of the bound of a face whose sum is known: below all sums.
constexpr double visited = -1;

// What is learnt about the sums of eq. (1) by visiting a face.
struct Visited_face
{
  Indexed_surface::Index face = 0;
  Sum_and_longest of_face;
  bool has_paths = false; // whether is known how the shortest paths run, and all faces were reached
  std::vector<double> distances; // from the face
  Bounds_in_ball around;

  // Of the sum of another face, by the triangle inequality.
  double bound(Indexed_surface::Index f, double rounding) const
  {
    return (of_face.sum + static_cast<double>(distances.size()) * distances[f]) * rounding;
  }
};

// Visits faces: the distances from one, and closer bounds around it, if the distances are those of shortest paths. Those who
// have distances of their own can visit faces at the same time.
template <typename Distances>
class Face_visitor
{
public:
  using Index = Indexed_surface::Index;
  static constexpr bool has_tree = Has_shortest_path_tree<Distances>::value;

  // Every bound is multiplied by `rounding`. The distances must outlive the object.
  Face_visitor(Distances& distances, Index number_of_faces, double rounding, bool is_parallel)
    : m_distances(distances), m_rounding(rounding), m_local_bounds(number_of_faces, is_parallel)
  {}

  // `bounds` of all sums, and the `largest` sum, as they are known before.
  void operator()(Index face, const std::vector<double>& bounds, double largest, Visited_face& result)
  {
    result.face = face;
    m_distances(face, result.distances);
    result.of_face = sum_and_longest(result.distances);
    result.around.clear();
    if constexpr (has_tree)
    {
      result.has_paths = std::isfinite(result.of_face.sum) && !m_distances.tree().order.empty();
      if (result.has_paths)
        m_local_bounds.lower(
          m_distances.arcs(), m_distances.tree(), result.distances, result.of_face.sum,
          (std::max)(largest, result.of_face.sum), m_rounding,
          [&](Index f) { return f == face ? visited : (std::min)(bounds[f], result.bound(f, m_rounding)); }, result.around);
    }
  }

private:
  Distances& m_distances;
  double m_rounding;
  Local_sum_bounds m_local_bounds;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_FACE_VISITOR_H
