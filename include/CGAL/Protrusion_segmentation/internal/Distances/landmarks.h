// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LANDMARKS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LANDMARKS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A number below `bound` that does not depend on the standard library's distributions. The bias is below
// bound / 2^32.
inline Indexed_surface::Index random_below(std::mt19937& generator, Indexed_surface::Index bound)
{
  return static_cast<Indexed_surface::Index>((static_cast<std::uint64_t>(generator()) * bound) >> 32);
}

// Step 1 of Section III.B.3: `count` different faces of `number_of_faces`, in ascending order.
inline std::vector<Indexed_surface::Index> select_landmarks(Indexed_surface::Index number_of_faces,
                                                         std::size_t count,
                                                         unsigned int random_seed)
{
  using Index = Indexed_surface::Index;
  std::vector<Index> faces(number_of_faces);
  std::iota(faces.begin(), faces.end(), Index(0));
  count = (std::min)(count, faces.size());
  std::mt19937 generator(random_seed);
  for (Index i = 0; i < count; ++i)
    std::swap(faces[i], faces[i + random_below(generator, number_of_faces - i)]);
  faces.resize(count);
  std::sort(faces.begin(), faces.end());
  return faces;
}

// The nearest landmark of every face, the lowest number where several are equally near; the same in whatever
// order landmarks are added.
class Nearest_landmarks
{
public:
  using Index = Indexed_surface::Index;

  explicit Nearest_landmarks(const Indexed_surface& surface)
    : m_distances(surface.number_of_faces(), (std::numeric_limits<double>::infinity)()),
      m_landmarks(surface.number_of_faces(), 0)
  {}

  Index number_of_faces() const { return static_cast<Index>(m_landmarks.size()); }
  Index landmark(Index face) const { return m_landmarks[face]; }
  double distance(Index face) const { return m_distances[face]; }

  // the distances of all faces from a landmark, by its number
  void add(Index landmark, const std::vector<double>& distances)
  {
    for (Index f = 0; f < number_of_faces(); ++f)
      add(f, landmark, distances[f]);
  }
  void add(const Nearest_landmarks& others)
  {
    for (Index f = 0; f < number_of_faces(); ++f)
      add(f, others.m_landmarks[f], others.m_distances[f]);
  }

private:
  void add(Index face, Index landmark, double distance)
  {
    if (distance < m_distances[face] ||
        (distance == m_distances[face] && landmark < m_landmarks[face]))
    {
      m_distances[face] = distance;
      m_landmarks[face] = landmark;
    }
  }

  std::vector<double> m_distances;
  std::vector<Index> m_landmarks;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LANDMARKS_H
