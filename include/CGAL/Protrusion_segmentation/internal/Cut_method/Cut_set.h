// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SET_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SET_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A segmentation of a connected surface by cuts, each of which splits a segment in two. Segments are those of a
// pool.
struct Cut_set
{
  using Index = Weighted_dual_graph::Index;

  struct Made_cut
  {
    Index segment, inner, outer;
    double value;
    double probability = 0;
  };

  std::vector<Index> segments; // that are left, ascending
  std::vector<Made_cut> cuts;  // in the order in which they were made
  double value = 0;            // sum of those of the cuts

  // The segments as cuts have made them, the smaller side of a cut first. That order comes from the shape alone, whichever
  // way its faces and nodes are numbered and whatever has been searched beside this set.
  std::vector<Index> in_order_of_cuts() const
  {
    if (cuts.empty())
      return segments;
    std::vector<Index> result;
    for (const Made_cut& cut : cuts)
      for (Index side : {cut.inner, cut.outer})
        if (std::binary_search(segments.begin(), segments.end(), side))
          result.push_back(side);
    return result;
  }

  Cut_set with(const Made_cut& cut) const
  {
    Cut_set result = *this;
    result.segments.erase(std::find(result.segments.begin(), result.segments.end(), cut.segment));
    for (Index side : {cut.inner, cut.outer})
      result.segments.insert(std::upper_bound(result.segments.begin(), result.segments.end(), side), side);
    result.cuts.push_back(cut);
    result.value += cut.value;
    return result;
  }
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SET_H
