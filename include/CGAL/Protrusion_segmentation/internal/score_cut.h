// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SCORE_CUT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SCORE_CUT_H

#include <CGAL/Protrusion_segmentation/internal/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/level_set_cuts.h>

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
  double score;                 // lower is better; infinite if the cut is of no use
};

// The area within `width` of the cut on one side, relative to a strip of that width: above 1 where the
// surface widens, the sudden widening that the paper looks for in its histograms.
inline double widening(Graph_partition& partition,
                       Seam_graph::Index part_label,
                       const Graph_partition::Nodes& along_cut,
                       bool side,
                       double cut_length,
                       double width)
{
  const Graph_partition::Nodes strip = partition.nodes_by_distance(
    along_cut,
    [&](Seam_graph::Index i)
    { return partition.label(i) == part_label && partition.is_inner(i) == side; },
    partition.graph().length, width);
  return partition.area(strip) / (cut_length * width);
}

// The score of the cut whose inner side is marked: its cost relative to the smaller side, less where the
// surface widens behind the cut.
inline double score_of_cut(Graph_partition& partition,
                           Seam_graph::Index part_label,
                           const Graph_partition::Nodes& inner,
                           double part_area)
{
  using Index = Seam_graph::Index;
  // width of the strips, relative to the square root of the smaller area
  constexpr double strip_width = 0.3;
  constexpr double widening_exponent = 2;
  const Seam_graph& graph = partition.graph();
  double cost = 0, length = 0;
  for (Index i : inner)
    for (Index arc : graph.arcs(i))
      if (partition.label(graph.target[arc]) == part_label && !partition.is_inner(graph.target[arc]))
      {
        cost += graph.capacity[arc];
        length += graph.border_length[arc];
      }
  const double area = partition.area(inner);
  const double relative = relative_cost(cost, area, part_area);
  if (!(length > 0) || !std::isfinite(relative))
    return (std::numeric_limits<double>::infinity)();
  const double width = strip_width * std::sqrt((std::min)(area, part_area - area));
  const auto [inside, outside] = partition.nodes_along_cut(part_label, inner);
  const double inner_widening = widening(partition, part_label, inside, true, length, width);
  const double outer_widening = widening(partition, part_label, outside, false, length, width);
  const double widest = (std::max)({inner_widening, outer_widening, 1e-6});
  return relative * std::exp(-widening_exponent * std::log(widest));
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SCORE_CUT_H
