// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_LIKE_PARTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_LIKE_PARTS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut_weights.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>

#include <algorithm>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Parts that even a like part makes no protrusions, or that any place of a tube would make, are evidence for none.
inline bool may_be_part(const Cut& cut)
{
  constexpr double least_log_odds = -2; // with -1 a gear loses its last tooth, decisions.md
  return cut.log_odds >= least_log_odds && is_distinct(cut.clues);
}

// What a part of that size, cut off with those log odds, says for a cut that separates one like it: as much as it takes to be as
// sure as that one, and more, since there are two.
inline double evidence_of_part(const Cut_weights& weights, const Cut& cut, const Size_of_part& size, double log_odds)
{
  const double missing = may_be_part(cut) && !cut.size.is_repeated ? (std::max)(0., log_odds - cut.log_odds) : 0;
  return weights.likeness(squared_difference(size, cut.size)) * (weights.like_part + missing);
}

// Finds parts that are like others, of all cuts of a surface before the first one is made. Each arm of a wide star says little by
// itself, but all arms together say much. Only like a sure part is evidence, if there are any.
inline void find_like_parts(const Cut_options& options, std::vector<Cut>& cuts)
{
  const Cut_weights& weights = options.weights;
  const auto is_sure = [&](const Cut& cut) { return options.is_sure(cut.log_odds); };
  const bool any_is_sure = std::any_of(cuts.begin(), cuts.end(), is_sure);
  for (Cut& cut : cuts)
    for (const Cut& other : cuts)
    {
      const double difference = squared_difference(cut.size, other.size);
      if (may_be_part(cut) && may_be_part(other) && (is_sure(other) || !any_is_sure) &&
          weights.is_like(difference) && are_disjoint(cut.inner, other.inner))
        cut.like_part = (std::max)(cut.like_part, weights.like_part * weights.likeness(difference));
    }
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_LIKE_PARTS_H
