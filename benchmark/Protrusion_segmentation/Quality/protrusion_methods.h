// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods of this package.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PROTRUSION_METHODS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PROTRUSION_METHODS_H

#include "Segmentation_method.h"

#include <vector>

// The default method, with the number of segments given and found by itself; the paper's method with
// every distance of Table I that it settles on, and without its candidate intervals.
std::vector<Segmentation_method> protrusion_methods();

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PROTRUSION_METHODS_H
