// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of the benchmark. Methods come from `protrusion_methods()` of the quality benchmark: a
// further one is registered there, once, and can be named here.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_TABLES_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_TABLES_H

#include "Benchmark_folder.h"
#include "Segmentation_method.h"

#include <cstddef>
#include <string>
#include <vector>

struct Options
{
  std::string folder;
  std::string models = "10-394/16";
  std::string methods = "Minimum-cut,Paper-GD";
  std::vector<int> tables = {1, 2, 3, 4, 5, 6, 7};
  std::size_t repetitions = 3;
  int large_model = 282; // 195,768 faces when subdivided
  int growth_model = 90;
  std::size_t largest_growth = 4100000;
  std::vector<std::size_t> threads = {2};
  int gap_model = 170; // 99,984 faces when subdivided
  double gap_limit = 60; // seconds
};

// Of the registered ones those that `options.methods` names, in its order.
// Throws `std::invalid_argument` if a name is unknown.
std::vector<Segmentation_method> methods_to_measure(const Options& options);

// 1. Table II of the paper: its method with each distance.
void print_distance_table(const Options& options, const Benchmark_folder& folder);

// 2. Against CGAL's segmentation by shape diameters, and against reading the file of the mesh.
void print_peer_table(const Options& options, const Benchmark_folder& folder);

// 3. One shape with four times as many faces in each step.
void print_growth_table(const Options& options, const Benchmark_folder& folder);

// 4. One thread against several.
void print_thread_table(const Options& options, const Benchmark_folder& folder);

// 5. The longest time in which a visitor is not asked whether to go on.
void print_gap_table(const Options& options, const Benchmark_folder& folder);

// 6. With Boost's shortest paths, and sections by CGAL's slicer.
void print_library_table(const Options& options, const Benchmark_folder& folder);

// 7. A million faces without protrusions.
void print_shape_table(const Options& options, const Benchmark_folder& folder);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_TABLES_H
