// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_VALUE_OF_CUT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_VALUE_OF_CUT_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_ingredients.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/level_set_cuts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A cut of a part in two connected sides.
struct Cut
{
  Graph_partition::Nodes inner; // the side of smaller area
  double value;                 // higher is better, below 0 it separates what belongs together
};

// The area within `width` of the cut on one side, relative to a strip of that width: above 1 where the
// surface widens, the sudden widening that the paper looks for in its histograms.
inline double widening(Graph_partition& partition,
                       Weighted_dual_graph::Index part_label,
                       const Graph_partition::Nodes& along_cut,
                       bool side,
                       double cut_length,
                       double width)
{
  const Graph_partition::Nodes strip = partition.nodes_by_distance(
    along_cut,
    [&](Weighted_dual_graph::Index i)
    { return partition.label(i) == part_label && partition.is_inner(i) == side; },
    partition.graph().lengths(), width);
  return partition.area(strip) / (cut_length * width);
}

// What of a cut tells whether people would cut there.
struct Cut_clues
{
  double concave_share;    // of the cut's length
  double relative_length;  // log of the length relative to the square root of the smaller area
  double part_size;        // log of the part's share of the area of the surface
  double larger_widening;  // log, of the two sides
  double smaller_widening;
};

// The probability that two points on different sides of a cut lie in different segments when people segment
// the surface: a logistic function of the clues. Short cuts in concave seams behind which one side widens
// suddenly and the other does not are good; large parts are divided rather than small ones. The weights come
// from a regression over the candidate cuts on half of the development models of the Princeton benchmark,
// rounded; changes by a tenth hardly matter.
inline double probability_of_cut(const Cut_clues& clues)
{
  constexpr double bias = -0.7;
  constexpr double concave_share_weight = 5;
  constexpr double relative_length_weight = -2.5;
  constexpr double part_size_weight = 1.3;
  constexpr double larger_widening_weight = 2;
  constexpr double smaller_widening_weight = -1;
  return 1 / (1 + std::exp(-(bias + concave_share_weight * clues.concave_share +
                             relative_length_weight * clues.relative_length +
                             part_size_weight * clues.part_size +
                             larger_widening_weight * clues.larger_widening +
                             smaller_widening_weight * clues.smaller_widening)));
}

inline Cut_clues clues_of_cut(Graph_partition& partition,
                              Weighted_dual_graph::Index part_label,
                              const Graph_partition::Nodes& inner,
                              double part_area)
{
  using Index = Weighted_dual_graph::Index;
  // width of the strips on both sides, relative to the square root of the smaller area
  constexpr double strip_width = 0.4;
  constexpr double least_widening = 1e-6;
  const Weighted_dual_graph& graph = partition.graph();
  double concave = 0, length = 0;
  for (Index i : inner)
    for (Index arc : graph.arcs(i))
      if (partition.label(graph.target[arc]) == part_label && !partition.is_inner(graph.target[arc]))
      {
        concave += graph.concave_border_length[arc];
        length += graph.border_length[arc];
      }
  length = (std::max)(length, 1e-9);
  const double area = partition.area(inner);
  const double size = std::sqrt((std::min)(area, part_area - area));
  const auto [inside, outside] = partition.nodes_along_cut(part_label, inner);
  const auto log_widening = [&](const Graph_partition::Nodes& along_cut, bool side)
  {
    return std::log((std::max)(
      least_widening, widening(partition, part_label, along_cut, side, length, strip_width * size)));
  };
  const double inner_widening = log_widening(inside, true);
  const double outer_widening = log_widening(outside, false);
  return {concave / length, std::log(length / size), std::log(part_area),
          (std::max)(inner_widening, outer_widening), (std::min)(inner_widening, outer_widening)};
}

// The clues that are among the ingredients; in place of the others their means over the candidate cuts of half
// of the development models.
inline Cut_clues without_left_out(Cut_clues clues, const Cut_ingredients& ingredients)
{
  constexpr Cut_clues mean = {0.54, 0.71, -1.77, 0.10, -0.24};
  if (!ingredients.concave_share)
    clues.concave_share = mean.concave_share;
  if (!ingredients.relative_length)
    clues.relative_length = mean.relative_length;
  if (!ingredients.part_size)
    clues.part_size = mean.part_size;
  if (!ingredients.widening)
  {
    clues.larger_widening = mean.larger_widening;
    clues.smaller_widening = mean.smaller_widening;
  }
  return clues;
}

// How much better a segmentation becomes by the cut whose inner side is marked: about the number of pairs of
// points on different sides, times the probability that they belong apart less the one that they belong
// together. The root keeps the largest parts from being cut for their size alone. Minus infinity if a side
// is too small to be a part.
inline double value_of_cut(Graph_partition& partition,
                           Weighted_dual_graph::Index part_label,
                           const Graph_partition::Nodes& inner,
                           double part_area,
                           const Cut_ingredients& ingredients = {})
{
  const double area = partition.area(inner);
  if (!is_large_enough(area, part_area))
    return -(std::numeric_limits<double>::infinity)();
  const Cut_clues clues = clues_of_cut(partition, part_label, inner, part_area);
  const double probability = probability_of_cut(without_left_out(clues, ingredients));
  return (2 * probability - 1) * std::sqrt(area * (part_area - area));
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_VALUE_OF_CUT_H
