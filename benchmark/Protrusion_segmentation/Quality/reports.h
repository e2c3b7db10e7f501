// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the benchmark writes: CSV files for programs, a Markdown page with the paper's tables for
// people.

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

// Markdown: the first rows, in one table; a line on the cells of the paper's tables that are won, if there are any; how
// far the means and the differences to the first method are certain.
void write_overview(std::ostream& out, const Results& results);
void write_cells_won(std::ostream& out, const Results& results);
void write_comparisons(std::ostream& out, const Results& results);

// All of these, and means of all scores; then, for each of the Rand index error, the Hamming distance and the cut
// discrepancy, a table by class, absolute and relative to the humans, beside what the paper
// publishes (its tables III, IV and V); then single models (its tables VI and VII).
void write_markdown(std::ostream& out, const Results& results);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_REPORTS_H
