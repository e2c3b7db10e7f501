// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of what is measured. A further method, ours or a peer, is a line in methods.cpp.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_METHODS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_METHODS_H

#include "Segmentation_method.h"

#include <string>
#include <vector>

// Ours first, then peers.
std::vector<Segmentation_method> all_methods();

// The methods named in a list such as "K-Means,Voronoi", in its order; "" stands for all that
// run by default.
// Throws `std::invalid_argument` if a name is unknown.
std::vector<Segmentation_method> chosen_methods(const std::string& list);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_METHODS_H
