// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_PREFETCH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_PREFETCH_H

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Asks for memory that will soon be read: a hint, which other compilers do without.
inline void prefetch(const void* memory)
{
#ifdef __GNUC__
  __builtin_prefetch(memory);
#else
  static_cast<void>(memory);
#endif
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_PREFETCH_H
