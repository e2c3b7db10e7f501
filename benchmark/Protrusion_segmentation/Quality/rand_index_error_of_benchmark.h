// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RAND_INDEX_ERROR_OF_BENCHMARK_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RAND_INDEX_ERROR_OF_BENCHMARK_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>

// The Rand index error as the program of the Princeton Segmentation Benchmark computes it, from the true one:
// what published figures are compared with.
//
// That program divides by n * floor((n - 1) / 2) in integers and not by the number of pairs, n * (n - 1) / 2.
// For an even number n of faces that is too little by the factor (n - 2) / (n - 1). Values that get above 1
// by that are cut to 1; two faces, where nothing would be left to divide by, are taken as one pair.
inline double rand_index_error_of_benchmark(double rand_index_error, std::size_t number_of_faces)
{
  CGAL_precondition(rand_index_error >= 0 && rand_index_error <= 1);
  if (number_of_faces % 2 != 0 || number_of_faces <= 2)
    return rand_index_error;
  const double n = static_cast<double>(number_of_faces);
  return (std::min)(1., rand_index_error * ((n - 1) / (n - 2)));
}

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RAND_INDEX_ERROR_OF_BENCHMARK_H
