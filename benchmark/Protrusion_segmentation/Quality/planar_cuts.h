// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Constrained planar cuts by the Point Cloud Library, if the benchmark was configured with it:
//
//   Markus Schoeler, Jeremie Papon and Florentin Woergoetter: Constrained Planar Cuts - Object Partitioning for Point
//   Clouds. IEEE Conference on Computer Vision and Pattern Recognition, 2015
//
// It is made for point clouds: points are spread over the faces, and a face gets the label that most of its points
// have. It takes no number of segments: of several settings the one is taken that comes nearest to it.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PLANAR_CUTS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PLANAR_CUTS_H

#include "Segmentation_method.h"

#include <cstddef>

struct Planar_cuts_options
{
  // Spread over the mesh, by area.
  std::size_t points = 40000;
  // Sides of voxels and of supervoxels, in units of the root of the mesh's area. Voxels must be wider than the points
  // are apart.
  double voxel = 0.012, supervoxel = 0.04;
  // Least number of links between supervoxels in a segment that is cut.
  unsigned int least_links = 60;
  // Planes tried for a cut; the library's 10,000 take too long.
  unsigned int planes = 600;
};

Labels planar_cuts_segmentation(const Mesh& mesh,
                                std::size_t number_of_segments,
                                unsigned int seed,
                                const Planar_cuts_options& options = Planar_cuts_options());

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PLANAR_CUTS_H
