// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_NUMBER_OF_SEGMENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_NUMBER_OF_SEGMENTS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_memo.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Protrusion_segmentation::internal {

// As many segments as there are before the largest drop of what one more gains, from surely a protrusion to none. One limit would fall
// between cuts of nearly the same value: one of a pair of legs would be cut off, and another one when a vertex moves.
//
// `gain(n)` is what segment n + 1 gains, nothing if there is none. It is called for n = 1, 2, and so on, while it is above
// `options.least_protrusion`.
template <typename Gain>
std::size_t number_before_largest_drop(Gain gain, const Cut_options& options)
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

// Whether enough of the value is that of cuts that mark a place of the surface.
inline bool has_distinct_cuts(const Cut_set& set)
{
  constexpr double least_share = 0.25; // of the value: some cuts in a rough tube or a terrain may be distinct by chance
  double of_distinct = 0, of_all = 0;
  for (const Cut_set::Made_cut& cut : set.cuts)
  {
    of_all += cut.value;
    of_distinct += cut.is_distinct ? cut.value : 0;
  }
  return of_distinct > least_share * of_all;
}

// The number of segments that is found automatically: the number before the largest drop, or one if hardly any of its cuts is
// distinct, since a tube is one piece, however it is bent. `best_set(n)`: the best cuts into n segments
template <typename Gain, typename BestSet>
std::size_t automatic_number_of_segments(Gain gain, BestSet best_set, const Cut_options& options)
{
  const std::size_t number = number_before_largest_drop(gain, options);
  return has_distinct_cuts(best_set(number)) ? number : 1;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_NUMBER_OF_SEGMENTS_H
