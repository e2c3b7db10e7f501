// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PROCESSOR_SECONDS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PROCESSOR_SECONDS_H

#include <time.h>

// Seconds that the processor spent on this thread: what else runs on the machine hardly matters.
inline double processor_seconds()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_PROCESSOR_SECONDS_H
