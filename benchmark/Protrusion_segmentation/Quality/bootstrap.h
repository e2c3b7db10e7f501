// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a mean over models would move with other models: percentile intervals of the bootstrap, after
//
//   Bradley Efron and Robert J. Tibshirani: An Introduction to the Bootstrap. Chapman & Hall, 1993
//
// The classes are given, the models of a class are a sample of it: models are drawn again within their classes. As
// classes of ten models are small, the intervals are a little too short (by about one part in twenty); a class of one model
// seems to be certain, so that intervals on a few models say little.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BOOTSTRAP_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BOOTSTRAP_H

#include <cstddef>
#include <vector>

// A value of each model, by its class. Classes may be empty, and do not count then.
using Values_by_class = std::vector<std::vector<double>>;

// Mean over the classes of the means over their values. There must be a value.
double mean_of_classes(const Values_by_class& values);

struct Mean_with_interval
{
  double mean;
  double low, high; // where 95 % of the means of samples drawn again are

  bool excludes_zero() const { return low > 0 || high < 0; }
};

// The same seed leads to the same interval, on every machine.
Mean_with_interval bootstrap_mean(const Values_by_class& values, unsigned int seed);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BOOTSTRAP_H
