// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_INGREDIENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_INGREDIENTS_H

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// What the search for cuts is made of. The quality benchmark leaves one out at a time to measure what it
// brings; everything else uses them all.
struct Cut_ingredients
{
  bool cost_of_seams = true;        // else a cut costs its length, wherever it runs
  bool minimum_cuts = true;         // around level sets, on the coarse graph
  bool choice_of_cheaper = true;    // of level set and minimum cut, else the minimum cut
  bool minimum_cut_on_faces = true; // when a cut is transferred to the faces
  // clues to the value of a cut; without one, its mean over candidates takes its place
  bool concave_share = true;
  bool relative_length = true;
  bool part_size = true;
  bool widening = true;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_INGREDIENTS_H
