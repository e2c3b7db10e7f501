// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of what is measured. A further method, ours or a peer, is a line in methods.cpp.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_METHODS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_METHODS_H

#include "Segmentation_method.h"

#include <vector>

// Ours first, then peers.
std::vector<Segmentation_method> all_methods();

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_METHODS_H
