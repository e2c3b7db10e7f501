// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the benchmark writes: CSV files for programs, tables in Markdown for people.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_REPORTS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_REPORTS_H

#include "Results.h"

#include <ostream>

// A line for each method and model. Empty fields have no value.
void write_models_csv(std::ostream& out, const Results& results);

// A line for each method and class, and for their mean.
void write_classes_csv(std::ostream& out, const Results& results);

// A line for each two methods and each of the Rand index error, the Hamming distance and the cut discrepancy: their
// difference with its interval, and in how many models each is better.
void write_differences_csv(std::ostream& out, const Results& results);

// A row for each method: means with their interval, and the difference to the first method.
void write_means(std::ostream& out, const Results& results);

// A row for each class, beside what the paper publishes in its tables III, IV and V.
void write_by_class(std::ostream& out, const Results& results);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_REPORTS_H
