// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A call in a child process: whatever it does, the benchmark goes on.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_GUARDED_RUN_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_GUARDED_RUN_H

#include <functional>
#include <string>

enum class Result
{
  VALID,
  INVALID,  // it returned something that is no segmentation
  REFUSED,  // it threw an exception
  CRASHED,  // a signal ended it
  TIMED_OUT
};

struct Outcome
{
  Result result;
  std::string text; // what is invalid, why it was refused, which signal
  double seconds = 0; // of processor time
};

// Runs `call`, which returns what is wrong with its result or an empty text, in a child process of at most
// `limit` seconds of processor time: other load on the machine does not count. POSIX only.
Outcome guarded_run(const std::function<std::string()>& call, unsigned int limit);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_GUARDED_RUN_H
