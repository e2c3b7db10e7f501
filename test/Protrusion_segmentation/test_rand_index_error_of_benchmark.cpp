// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Rand index error of the benchmark's program, which divides by n * floor((n - 1) / 2), from the true one.

#include "check.h"
#include "labeled_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Metrics/rand_index_error_of_benchmark.h>

int main()
{
  const auto converted = [](const Labels& a, const Labels& b)
  {
    const double error = metrics_of(strip_of_squares(a.size()), a, b).rand_index_error;
    return CGAL::Protrusion_segmentation::internal::rand_index_error_of_benchmark(error, a.size());
  };
  CHECK_CLOSE(converted({0, 1, 1, 1}, {0, 0, 1, 1}), 3 / (4 * 1.), exact);
  CHECK_CLOSE(converted({0, 0, 0, 1, 1, 1}, {0, 0, 0, 0, 0, 0}), 9 / (6 * 2.), exact);
  CHECK_CLOSE(converted({0, 1, 1}, {0, 0, 1}), 2 / (3 * 1.), exact);
  CHECK_CLOSE(converted({0, 0, 1, 1, 1}, {0, 0, 0, 0, 0}), 6 / (5 * 2.), exact);
  CHECK_EQUAL(converted({0, 1, 2, 3}, {0, 0, 0, 0}), 1); // 6 / 4, cut
  CHECK_EQUAL(converted({0, 1, 2, 3}, {0, 1, 2, 3}), 0);
  CHECK_EQUAL(converted({0, 1}, {0, 0}), 1); // one pair, though floor(1 / 2) is 0
  CHECK_EQUAL(converted({0}, {0}), 0);
  CHECK_EQUAL(converted({}, {}), 0);
  return check::result();
}
