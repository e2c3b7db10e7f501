// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_OPTIONS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_OPTIONS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut_weights.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Protrusion_segmentation::internal {

// The constants of the default method that a benchmark may vary. Lengths are in units of the square root of
// the area of the surface. All were chosen on three quarters of the development models of the Princeton benchmark and lie
// on plateaus, unless said otherwise.
struct Cut_options
{
  // A cut along a seam of concave curvature c costs least + (1 - least) exp(-decay c) per unit of length.
  double least_cost = 0.02;
  double cost_decay = 0.1;
  double convex_share = 0.2; // a ridge counts as a seam of that share of its curvature

  std::size_t level_sets = 12;      // candidates of a segment that are level sets of distances from tips,
  std::size_t regions = 8;          // and connected regions
  // The cheapest level sets, which may cross each other. Halves of a ring do, and would leave no place for its teeth.
  std::size_t crossing_level_sets = 10;
  double sure_log_odds = 3;         // least log odds of cuts that are made together: 20 to 1; infinity: none are
  // the value of a cut relative to the area of its segment that is expected at most: 1/2 is possible, this is rare
  double largest_relative_value = 0.25;
  bool moves_borders_on_faces = true; // borders become minimum cuts once more on the faces

  // Without a number of segments: the largest drop of the gain between these two ends the segmentation.
  double surely_protrusion = 0.06;
  double least_protrusion = 0.02;

  Cut_weights weights = {};

  bool is_sure(double log_odds) const { return log_odds >= sure_log_odds; }

  double cost(double border_length, double curvature) const
  {
    const double strength = curvature > 0 ? curvature : -curvature * convex_share;
    return border_length * (least_cost + (1 - least_cost) * std::exp(-cost_decay * strength));
  }
};

// Over what radius normals are averaged, in units of the square root of the area; between .015 and .05 without effect.
constexpr double normal_radius = 0.03;

// Over which rims of plates and directions at the border are averaged, in the same units. With .2 fewer thin plates are right and
// terrain is cut, with .1 no plates are right, and arms are cut in two.
constexpr double outline_radius = 0.15;

// How wide a seam is by that, in the same units: at most twice as wide. With .04 legs of tables have rings on top.
constexpr double width_of_seam = 0.05;

// A side of a cut with a smaller share of the surface is a detail of the mesh and no segment of the shape.
constexpr double least_area_of_segment = 0.0025;

inline bool is_large_enough(double area, double segment_area)
{
  return (std::min)(area, segment_area - area) >= least_area_of_segment;
}

// The cost of a cut relative to an area. The exponent lies between the relative length of a loop on a surface, 1/2,
// which finds the smallest necks, and the ratio cut, 1, which finds halves: 3/4.
inline double cost_for_area(double cost, double area)
{
  return cost / (std::sqrt(area) * std::sqrt(std::sqrt(area)));
}

// That of a cut, for the area of its smaller side; infinite if a side is too small to be a segment.
inline double relative_cost(double cost, double area, double segment_area)
{
  return is_large_enough(area, segment_area) ? cost_for_area(cost, (std::min)(area, segment_area - area))
                                             : std::numeric_limits<double>::infinity();
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_OPTIONS_H
