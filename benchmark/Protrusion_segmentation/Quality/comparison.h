// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether two methods differ, or only their means do.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_COMPARISON_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_COMPARISON_H

#include "Results.h"
#include "bootstrap.h"

#include <cstddef>
#include <optional>

// Of a row's scores; no value if no model has one.
std::optional<Mean_with_interval> mean_with_interval(const Results& results,
                                                     std::size_t row,
                                                     Score score);

struct Comparison
{
  Mean_with_interval difference; // first minus second, on the models on which both have a score
  std::size_t first_is_better = 0, both_are_equal = 0, second_is_better = 0; // numbers of models
};

// No value if no model has a score of both.
std::optional<Comparison> comparison(const Results& results,
                                     std::size_t first,
                                     std::size_t second,
                                     Score score);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_COMPARISON_H
