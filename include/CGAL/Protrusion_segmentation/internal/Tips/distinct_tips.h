// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_DISTINCT_TIPS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_DISTINCT_TIPS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A tip's protrusion holds no other tip. Where fewer tips than that are picked, further ones, as far as can be from all
// others, are added that make no segments: a foot and what its protrusion shall not swallow, the other feet, the head
// and the tail.
constexpr std::size_t least_number_of_tips = 6;

// Picked tips without those that mean the same protrusion as an earlier one: the same face again, or a face that
// shares a vertex with it. Nobody tells two tips so near apart, and no border fits between them.
inline std::vector<Indexed_surface::Index> distinct_tips(const Indexed_surface& surface,
                                                         const std::vector<Indexed_surface::Index>& tips)
{
  using Index = Indexed_surface::Index;
  std::vector<bool> is_taken(surface.number_of_vertices(), false);
  std::vector<Index> result;
  for (Index tip : tips)
  {
    bool is_new = true;
    for (Index c = surface.first_corner(tip); c < surface.first_corner(tip + 1); ++c)
      is_new = is_new && !is_taken[surface.vertex(c)];
    if (!is_new)
      continue;
    result.push_back(tip);
    for (Index c = surface.first_corner(tip); c < surface.first_corner(tip + 1); ++c)
      is_taken[surface.vertex(c)] = true;
  }
  return result;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_TIPS_DISTINCT_TIPS_H
