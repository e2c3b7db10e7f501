// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_TIMING_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_TIMING_H

#include <chrono>

namespace tool
{

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Shares of the progress: before it, the file is read, and behind it, borders are smoothed and files written.
constexpr double begin_of_segmentation = 0.2;
constexpr double end_of_segmentation = 0.8;

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_TIMING_H
