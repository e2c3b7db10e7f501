// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segmentations by others, and trivial ones, measured in the same run as ours.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PEERS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PEERS_H

#include "Segmentation_method.h"

#include <vector>

// Each of its own header: randomized cuts, spectral cuts, core extraction, planar cuts if the benchmark was configured with
// the library that has them, K-Means. And farthest-point Voronoi cells (the paper's step 2 with no borders looked
// for); one segment for the whole mesh.
std::vector<Segmentation_method> clustering_methods();

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PEERS_H
