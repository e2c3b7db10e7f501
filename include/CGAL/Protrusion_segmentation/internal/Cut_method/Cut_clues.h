// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CLUES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CLUES_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// What of a cut tells whether people would cut there.
struct Cut_clues
{
  double concave_share;    // of the cut's length
  double relative_length;  // log of the length relative to the square root of the smaller area
  double segment_size;     // log of the segment's share of the area of the surface
  double larger_widening;  // log, of the two sides
  double smaller_widening;
};

// The log of the area within `width` of the cut on one side, relative to a strip of that width: above 0 where the
// surface widens, the sudden widening that the paper looks for in its histograms.
inline double widening(Graph_partition& partition,
                       Weighted_dual_graph::Index segment,
                       const Graph_partition::Nodes& along_cut,
                       bool inner,
                       double cut_length,
                       double width)
{
  constexpr double least_widening = 1e-6;
  const Nodes_by_distance strip =
    partition.nodes_by_distance_on_side(along_cut, segment, inner, partition.graph().lengths(), width);
  return std::log((std::max)(least_widening, partition.area(strip.nodes) / (cut_length * width)));
}

// The clues of the cut whose inner side, marked, is `inner`.
inline Cut_clues clues_of_cut(Graph_partition& partition,
                              Weighted_dual_graph::Index segment,
                              const Graph_partition::Nodes& inner,
                              double segment_area)
{
  using Index = Weighted_dual_graph::Index;
  // width of the strips on both sides, relative to the square root of the smaller area
  constexpr double strip_width = 0.4;
  constexpr double least_length = 1e-9;
  const Weighted_dual_graph& graph = partition.graph();
  double concave = 0, length = 0;
  partition.for_each_arc_of_cut(segment, inner, [&](Index arc, Index, Index)
                                {
                                  concave += graph.concave_border_length[arc];
                                  length += graph.border_length[arc];
                                });
  length = (std::max)(length, least_length);
  const double area = partition.area(inner);
  const double size = std::sqrt((std::min)(area, segment_area - area));
  const auto [inside, outside] = partition.nodes_along_cut(segment, inner);
  const double width = strip_width * size;
  const double inner_widening = widening(partition, segment, inside, true, length, width);
  const double outer_widening = widening(partition, segment, outside, false, length, width);
  return {concave / length, std::log(length / size), std::log(segment_area),
          (std::max)(inner_widening, outer_widening), (std::min)(inner_widening, outer_widening)};
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CLUES_H
