// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SUBTREE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SUBTREE_H

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Whether each segment is the given one or sticks out of it, directly or not. The body is its own parent.
template <typename Number>
std::vector<bool> subtree(std::size_t segment, const std::vector<Number>& parents)
{
  std::vector<bool> inside(parents.size(), false);
  for (std::size_t s = 0; s < parents.size(); ++s)
  {
    std::size_t ancestor = s;
    while (ancestor != segment && parents[ancestor] != ancestor)
      ancestor = parents[ancestor];
    inside[s] = ancestor == segment;
  }
  return inside;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SUBTREE_H
