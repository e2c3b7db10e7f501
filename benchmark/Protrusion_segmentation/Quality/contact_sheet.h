// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One HTML page with a picture of each model coloured by the segments of a method, beside a
// human's: the models on which the method is farthest from the humans come first.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CONTACT_SHEET_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CONTACT_SHEET_H

#include "Results.h"

#include <cstddef>
#include <ostream>

void write_contact_sheet(std::ostream& out, const Benchmark_folder& folder, const Results& results,
                         std::size_t method);

// One with a row for each of ten models, taken at equal distances from the list, and a column for each method.
void write_comparison_sheet(std::ostream& out, const Benchmark_folder& folder, const Results& results);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CONTACT_SHEET_H
