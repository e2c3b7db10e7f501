// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_PEAK_MEMORY_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_PEAK_MEMORY_H

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#define PROTRUSION_SEGMENTATION_HAS_RESOURCE_USAGE
#endif

#include <cstddef>
#include <optional>

namespace tool
{

// The most bytes of memory that the process has had at once; none where the system does not tell.
inline std::optional<std::size_t> peak_memory()
{
#ifdef PROTRUSION_SEGMENTATION_HAS_RESOURCE_USAGE
#ifdef __APPLE__
  constexpr std::size_t unit = 1;
#else
  constexpr std::size_t unit = 1024;
#endif
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) == 0)
    return static_cast<std::size_t>(usage.ru_maxrss) * unit;
#endif
  return std::nullopt;
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_PEAK_MEMORY_H
