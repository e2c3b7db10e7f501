// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures of the paper's tables III to V, to be printed beside ours.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PUBLISHED_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PUBLISHED_H

#include "Scores.h"

#include <optional>
#include <string>
#include <vector>

// The eleven classes of tables III to V.
const std::vector<std::string>& published_classes();

// The columns of the tables.
enum class Published_method { protrusion, randomized_cuts, k_means };
constexpr Published_method published_methods[] =
  {Published_method::protrusion, Published_method::randomized_cuts, Published_method::k_means};
std::string published_name(Published_method method);

// Tables III (cut discrepancy), IV (Hamming distance) and V (Rand index error). The paper prints differences to people's
// errors, relative to these and without a sign; here they have one where other sources tell it, and are made absolute by
// the errors of people that the benchmark publishes. No value for other scores and classes.
std::optional<double> published_absolute(Score score, const std::string& class_name,
                                         Published_method method);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PUBLISHED_H
