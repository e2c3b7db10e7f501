// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What fills the rows of the tables: methods that are run, and folders of segmentations that others made.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CONTESTANTS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CONTESTANTS_H

#include "Benchmark_folder.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

struct Timed_labels
{
  Labels labels;
  std::optional<double> seconds; // of the processor
};

struct Contestant
{
  std::string name;
  // May throw: what it says is the reason why there is no segmentation.
  std::function<Timed_labels(const Model&, unsigned int seed)> segment;
};

// Those that a list such as "K-Means,Voronoi" names, in its order; "" stands for all methods that run by default.
// `folders` are NAME=FOLDER, see Segmentation_folder.h: the list may name them as well, and those that it does not
// name come last. A folder with the name of a method takes its place: what was made once need not be made again.
// Throws `std::invalid_argument` if a name is unknown, or two folders have one.
std::vector<Contestant> chosen_contestants(const std::string& list,
                                           const std::vector<std::string>& folders);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_CONTESTANTS_H
