// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segmentations by others, and trivial ones, measured in the same run as ours.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PEERS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PEERS_H

#include "Segmentation_method.h"

#include <vector>

// CGAL's segmentation by shape diameters, at its defaults (5 clusters, smoothness 0.26) and with
// 3 clusters and smoothness 0.1, one of its best two settings in the Rand index error, and better
// than the other in the rest. It ignores the number of segments.
std::vector<Segmentation_method> sdf_methods();

// K-Means, see k_means.h; farthest-point Voronoi cells (the paper's step 2 with no borders looked
// for); one segment for the whole mesh.
std::vector<Segmentation_method> clustering_methods();

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PEERS_H
