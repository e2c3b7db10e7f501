// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_THREAD_WORKSPACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_THREAD_WORKSPACES_H

#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <utility>

namespace CGAL::Protrusion_segmentation::internal {

// A workspace, and a copy of it for every thread, which are kept from one loop to the next.
template <typename Workspace>
class Thread_workspaces
{
public:
  template <typename... Arguments>
  explicit Thread_workspaces(Arguments&&... arguments) : m_own(std::forward<Arguments>(arguments)...)
  {}
  Thread_workspaces(const Thread_workspaces&) = delete;
  Thread_workspaces& operator=(const Thread_workspaces&) = delete;

  Workspace& own() { return m_own; }

  // Calls `body(workspace, i)` for every i from 0 to n - 1: in that order with the workspace, or, if parallel, in any order
  // with those of the threads. A body may call this itself, where it needs its workspace no more as it is.
  template <typename Body>
  void for_each_index(std::size_t n, bool parallel, Body body)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if (parallel)
    {
      tbb::parallel_for(std::size_t(0), n, [&](std::size_t i) { body(m_of_threads.local(), i); });
      return;
    }
#endif
    internal::for_each_index(n, false, m_own, body, [](const Workspace&) {});
    static_cast<void>(parallel);
  }

  // Calls `visit(workspace)` for each.
  template <typename Visit>
  void for_each(Visit visit) const
  {
    visit(m_own);
#ifdef CGAL_LINKED_WITH_TBB
    for (const Workspace& workspace : m_of_threads)
      visit(workspace);
#endif
  }

private:
  Workspace m_own;
#ifdef CGAL_LINKED_WITH_TBB
  tbb::enumerable_thread_specific<Workspace> m_of_threads{[this] { return Workspace(m_own); }};
#endif
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_THREAD_WORKSPACES_H
