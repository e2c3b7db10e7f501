// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CUT_WEIGHTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CUT_WEIGHTS_H

#include <algorithm>
#include <cmath>

namespace CGAL::Protrusion_segmentation::internal {

// What a cut says of itself, see `Clues_of_cut`. All clues are independent of scale.
struct Cut_clues
{
  double concave_share;    // share of the cut's length that lies in a concave seam; less of a rough surface, see `weight_of_valleys()`
  double relative_length;  // log of the length relative to the square root of the smaller side's area; earlier borders of a sheet count
  double segment_size;     // log of the segment's share of the area of the component
  double widening;         // log of the area of a strip beside the cut relative to a straight one, the larger one of the two sides
  double larger_shoulder;  // growth of the opening over such a strip, relative to the strip's area: 1 in
  double smaller_shoulder; // a wall that a rod sticks out of, 0 along the rod, -1 at its end; of the two sides
  double roundness;        // log of the area of the opening relative to a circle of the cut's length
  double neighbors;        // log of the length of earlier borders around the smaller side relative to the cut
  double mean_cost;        // log of the cost of a unit of length
  double thickness;        // log of the volume of the smaller side relative to its area and opening
  double pocket;           // of a smaller side that goes into the body, its volume relative to its area and opening, else 0
  double several_loops;    // 1 if the cut consists of several loops, else 0
  double flatness;         // of the area of the smaller side, the share that faces one way and not the
                           // other: 1 of a piece of a plane, 1/2 of a half sphere, near 0 of a limb; 0 of the limb of a sheet
};

// The weights of the clues, fitted to human segmentations of three quarters of the development models of the Princeton
// benchmark by `fit_cut_weights`. Decisions and figures are in decisions.md of the benchmark.
struct Cut_weights
{
  double bias = -2.45;
  double concave_share = 6;
  double relative_length = -3.7;
  // of a cut that leaves six times as much tube as it is wide: shorter cuts across a smooth tube say no more
  double least_relative_length = -0.3;
  double segment_size = 0.8;
  double widening = 2.4;
  double larger_shoulder = 8;
  double least_larger_shoulder = 0.1; // less is a tube that widens by chance
  double largest_larger_shoulder = 0.3;
  double smaller_shoulder = 1;
  double roundness = -0.6;
  double neighbors = -1;
  double surrounded = -3; // what has little but earlier borders around it is a part of the core between limbs
  double most_neighbors = 1.2;
  double mean_cost = -0.8;
  double thickness = 0.3; // without it disks of some plates are cut
  double pocket = -10; // what goes in is no protrusion
  double several_loops = -1.2; // half of a ring is no part
  double flatness = -12; // a hill, a scale or a pocket faces one way as a whole and is no protrusion
  double least_flatness = 0.6;
  double like_part = 1; // of a part like one cut off before, such as the other leg: either is evidence for the other
  double deviation_of_like_part = 0.15; // of logarithms of sizes; with .2 halves of a star's core are like its arms

  // What the clues say together, as the logarithm of odds.
  double operator()(const Cut_clues& clues) const
  {
    const double shoulder = (std::min)(largest_larger_shoulder, (std::max)(least_larger_shoulder, clues.larger_shoulder));
    return bias + concave_share * clues.concave_share +
           relative_length * (std::max)(least_relative_length, clues.relative_length) +
           segment_size * clues.segment_size + widening * clues.widening + larger_shoulder * shoulder +
           smaller_shoulder * clues.smaller_shoulder + roundness * clues.roundness + neighbors * clues.neighbors +
           surrounded * (std::max)(0., clues.neighbors - most_neighbors) + mean_cost * clues.mean_cost + thickness * clues.thickness +
           pocket * clues.pocket + several_loops * clues.several_loops + flatness * (std::max)(0., clues.flatness - least_flatness);
  }

  // Whether parts that differ by that much are alike.
  bool is_like(double squared_difference) const
  {
    return squared_difference < deviation_of_like_part * deviation_of_like_part;
  }

  // How much a part is like one that differs from it by that much: 1 if they are equal.
  double likeness(double squared_difference) const
  {
    return std::exp(-squared_difference / (2 * deviation_of_like_part * deviation_of_like_part));
  }
};

// Whether a cut marks a place of the surface. Others, of which a bent tube is full, say where to divide what must be divided.
inline bool is_distinct(const Cut_clues& clues)
{
  constexpr double least_widening = 0.15; // or shoulder; the bends of springs and knots reach .11
  constexpr double deep_seam = -1.5;      // a cost of a fifth
  return (std::max)(clues.widening, clues.larger_shoulder) > least_widening || clues.mean_cost < deep_seam;
}

inline double logistic(double log_odds)
{
  return 1 / (1 + std::exp(-log_odds));
}

// The probability that people put two points on different sides of a border into different segments. The log odds that cuts
// are chosen by overestimate it, since the best of many cuts is chosen: both constants calibrate them (`border_probabilities`).
inline double probability_of_border(double log_odds)
{
  constexpr double probability_bias = 0.53;
  constexpr double probability_slope = 0.25;
  return logistic(probability_bias + probability_slope * log_odds);
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CUT_WEIGHTS_H
