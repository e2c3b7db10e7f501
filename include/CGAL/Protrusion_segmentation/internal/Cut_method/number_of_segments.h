// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_NUMBER_OF_SEGMENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_NUMBER_OF_SEGMENTS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Protrusion_segmentation::internal {

// The number of segments that is found automatically: as many as there are before the largest drop of what one more gains, from
// surely a protrusion to none. One limit would fall between cuts of nearly the same value: one of a pair of legs would be
// cut off, and another one when a vertex moves.
//
// `gain(n)` is what segment n + 1 gains, nothing if there is none. It is called for n = 1, 2, and so on, while it is above
// `options.least_protrusion`.
template <typename Gain>
std::size_t automatic_number_of_segments(Gain gain, const Cut_options& options)
{
  std::size_t best = 1;
  double largest_drop = 0, before = options.surely_protrusion;
  for (std::size_t number = 1; before > options.least_protrusion; ++number)
  {
    const std::optional<double> found = gain(number);
    const double next = (std::max)(found.value_or(options.least_protrusion), options.least_protrusion);
    if (before - next > largest_drop)
    {
      largest_drop = before - next;
      best = number;
    }
    before = (std::min)(before, next);
  }
  return best;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_NUMBER_OF_SEGMENTS_H
