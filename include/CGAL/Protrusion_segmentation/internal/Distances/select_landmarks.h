// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SELECT_LANDMARKS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SELECT_LANDMARKS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

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

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_SELECT_LANDMARKS_H
