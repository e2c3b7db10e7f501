// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_clues.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/level_set_cuts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A cut of a segment in two connected sides.
struct Cut
{
  Graph_partition::Nodes inner; // the side of smaller area
  double root_of_areas = 0;     // of the product of the areas of both sides
  Cut_clues clues = {};
  double value = 0;       // higher is better, below 0 it separates what belongs together
  double probability = 0; // that people put the sides into different segments
};

// Values a cut by its clues: how much better a segmentation becomes by it. That is about the number of pairs of points on
// different sides, times what speaks for it: an estimate of the probability that they belong apart less the one that they
// belong together. The root keeps the largest segments from being cut for their size alone.
inline void value_by_clues(const Cut_policy& policy, Cut& cut)
{
  const double log_odds = policy.log_odds(cut.clues);
  cut.probability = probability_of_border(log_odds);
  cut.value = (2 * logistic(log_odds) - 1) * cut.root_of_areas;
}

// Equal ones stay in their order.
inline void sort_best_first(std::vector<Cut>& cuts)
{
  std::stable_sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.value > b.value; });
}

// Measures and values a cut; its value is minus infinity if a side is too small to be a segment. `nodes` are those of the
// segment, `cut.inner` is marked.
inline void value_cut(Graph_partition& partition,
                      Weighted_dual_graph::Index segment,
                      const Graph_partition::Nodes& nodes,
                      double segment_area,
                      const Cut_policy& policy,
                      Cut& cut)
{
  const double area = partition.area(cut.inner);
  cut.value = -(std::numeric_limits<double>::infinity)();
  if (!is_large_enough(area, segment_area))
    return;
  cut.root_of_areas = std::sqrt(area * (segment_area - area));
  cut.clues = Clues_of_cut(partition, segment, nodes, cut.inner, segment_area)();
  value_by_clues(policy, cut);
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_H
