// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_ALONG_SMOOTH_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_ALONG_SMOOTH_BORDERS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Cut_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Face_cutter.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Vertex_shares.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

struct Smooth_borders
{
  Cut_surface surface;
  std::size_t number_of_fixed_segments = 0; // that would have been torn or lost, and keep their faces
};

// Moves the borders between segments to smooth lines, along which faces are cut. A segment that does not come out in as many
// connected parts as it had keeps its faces, as if it were no part of the surface.
inline Smooth_borders cut_along_smooth_borders(const Indexed_surface& surface,
                                               const std::vector<Indexed_surface::Index>& segment_of_face,
                                               std::size_t number_of_segments,
                                               std::size_t number_of_rounds)
{
  std::vector<std::size_t> parts(number_of_segments, 0);
  for (Indexed_surface::Index label : label_components(surface, segment_of_face).label)
    ++parts[label];
  std::vector<bool> is_fixed(number_of_segments, number_of_rounds == 0);
  for (;;)
  {
    Vertex_shares shares(surface, segment_of_face, is_fixed);
    shares.smooth(number_of_rounds);
    Cut_surface result = Face_cutter(surface, segment_of_face, is_fixed, shares).cut();
    const bool is_surface = result.is_surface();
    const std::vector<std::size_t> parts_now = result.connected_parts(number_of_segments);
    bool is_done = true;
    for (std::size_t s = 0; s < number_of_segments; ++s)
      if (!is_fixed[s] && (parts_now[s] != parts[s] || !is_surface))
      {
        is_fixed[s] = true;
        is_done = false;
      }
    if (is_done)
      return {std::move(result),
              static_cast<std::size_t>(std::count(is_fixed.begin(), is_fixed.end(), true))};
  }
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_ALONG_SMOOTH_BORDERS_H
