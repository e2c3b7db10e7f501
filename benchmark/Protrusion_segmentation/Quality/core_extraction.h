// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The method from which the idea of feature points comes, after
//
//   Sagi Katz, George Leifman and Ayellet Tal: Mesh segmentation using feature point and core extraction. The Visual
//   Computer 21(8-10), 2005
//
// as far as the article allows: the decimated mesh is laid out in space so that straight distances are near to those
// along it (multidimensional scaling), and bent limbs are stretched; feature points are on the convex hull of that, and
// farther from all other faces than their neighbors; what lies on the hull when all is turned inside out in a sphere is
// the core, and grows until some feature points are parted; pieces with several are split in turn, and what lies between
// them is a segment; the borders are moved to minimum cuts.
//
// What is different: classical scaling instead of an iterative one; pieces are not scaled anew; and if more segments are
// found than are asked for, the smallest ones go to their neighbors. There may be fewer.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CORE_EXTRACTION_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CORE_EXTRACTION_H

#include "Segmentation_method.h"

#include <cstddef>

struct Core_extraction_options
{
  // Of the decimated mesh: all distances between them are needed.
  std::size_t faces = 1000;
  // Feature points that are nearer to each other than this share of the largest distance are one.
  double least_distance = 0.1;
  // How far the core may grow at most, as a share of the largest distance, and in how many steps.
  double largest_growth = 0.3;
  std::size_t steps = 30;
  // See `all_seams()`.
  double exponent = 10;
  // How far a border may move, as a share of the depth of its protrusion.
  double band = 0.4;
};

Labels core_extraction_segmentation(const Mesh& mesh,
                                    std::size_t number_of_segments,
                                    const Core_extraction_options& options = Core_extraction_options());

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CORE_EXTRACTION_H
