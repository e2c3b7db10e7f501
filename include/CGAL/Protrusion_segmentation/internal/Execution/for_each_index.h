// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_FOR_EACH_INDEX_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_FOR_EACH_INDEX_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL::Protrusion_segmentation::internal {

// Whether a concurrency tag asks for several threads.
template <typename ConcurrencyTag>
constexpr bool is_parallel()
{
  constexpr bool parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!parallel, "Parallel_tag is enabled but TBB is unavailable.");
#endif
  return parallel;
}

// Calls `body(workspace, i)` for every i from 0 to n - 1 and, in the end, `finish(workspace)`: once with
// `workspace`, or, if parallel, in any order with copies of it, one a thread. So that the result does not
// depend on the number of threads, `finish` must not depend on the order of its calls, nor on which i a
// workspace saw.
template <typename Workspace, typename Body, typename Finish>
void for_each_index(std::size_t n, bool parallel, Workspace& workspace, Body body, Finish finish)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (parallel)
  {
    tbb::enumerable_thread_specific<Workspace> workspaces(workspace);
    tbb::parallel_for(std::size_t(0), n, [&](std::size_t i) { body(workspaces.local(), i); });
    workspaces.combine_each(finish);
    return;
  }
#endif
  static_cast<void>(parallel);
  for (std::size_t i = 0; i < n; ++i)
    body(workspace, i);
  finish(workspace);
}

// The same without a workspace: `body(i)`.
template <typename Body>
void for_each_index(std::size_t n, bool parallel, Body body)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (parallel)
  {
    tbb::parallel_for(std::size_t(0), n, body);
    return;
  }
#endif
  static_cast<void>(parallel);
  for (std::size_t i = 0; i < n; ++i)
    body(i);
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_FOR_EACH_INDEX_H
