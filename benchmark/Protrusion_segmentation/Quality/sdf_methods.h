// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's segmentation by shape diameters (Surface_mesh_segmentation).

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SDF_METHODS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SDF_METHODS_H

#include "Segmentation_method.h"

#include <vector>

// SDF-5-0.26: its defaults (5 clusters, smoothness 0.26); SDF-3-0.1: one of its best two fixed settings in the Rand
// index error, and better than the other in the rest; both ignore the number of segments. SDF-k: clusters and
// smoothness with which the number of segments comes nearest to the one that is asked for.
std::vector<Segmentation_method> sdf_methods();

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_SDF_METHODS_H
