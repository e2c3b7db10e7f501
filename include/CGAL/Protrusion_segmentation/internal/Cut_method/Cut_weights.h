// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_WEIGHTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_WEIGHTS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_clues.h>

#include <algorithm>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// How much each clue speaks for a cut. Good are short, round cuts in concave seams, dear beside them, behind which one side
// widens suddenly, best as a shoulder that shows its face to the other side; large segments are divided rather than small
// ones, and one loop is better than several. The weights come from a fit over candidate cuts of the Princeton benchmark,
// rounded; `benchmark/Protrusion_segmentation/Quality` has a program that fits them in the loop.
struct Cut_weights
{
  double bias = -2;
  double concave_share = 6;
  double relative_length = -3.7;
  // Of a cut that leaves six times as much tube as it is wide on its shorter side. If shorter cuts spoke the more for
  // themselves, a smooth tube would be cut anywhere. Between -.2 and -.6 the Rand index error on the development models
  // of the Princeton benchmark is the same.
  double least_relative_length = -0.3;
  double segment_size = 0.8;
  double larger_widening = 2.4;
  double smaller_widening = -0.2;
  double larger_shoulder = 4;
  // Less is a tube that widens by chance, more sticks out no better. The Rand index error on the development models of the
  // Princeton benchmark is the same within .001 with weights of 4 to 8 and upper limits of .3 to .4, and without shoulders;
  // but then more trunks of other animals are cut into bands.
  double least_larger_shoulder = 0.1;
  double largest_larger_shoulder = 0.4;
  double smaller_shoulder = 1;
  double roundness = -0.6;
  double neighbors = -1;
  double contrast = 0.4;
  double mean_cost = -0.8;
  double thickness = 0.3;
  double inner_concavity = -0.04;
  double several_loops = -1.5;

  // What the clues say together, as the logarithm of odds.
  double operator()(const Cut_clues& clues) const
  {
    return bias + concave_share * clues.concave_share +
           relative_length * (std::max)(least_relative_length, clues.relative_length) +
           segment_size * clues.segment_size + larger_widening * clues.larger_widening +
           smaller_widening * clues.smaller_widening +
           larger_shoulder *
             (std::min)(largest_larger_shoulder, (std::max)(least_larger_shoulder, clues.larger_shoulder)) +
           smaller_shoulder * clues.smaller_shoulder + roundness * clues.roundness + neighbors * clues.neighbors +
           contrast * clues.contrast + mean_cost * clues.mean_cost + thickness * clues.thickness +
           inner_concavity * clues.inner_concavity + several_loops * clues.several_loops;
  }
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_WEIGHTS_H
