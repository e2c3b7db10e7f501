// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_FOR_EACH_SIDE_BY_SIDE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_FOR_EACH_SIDE_BY_SIDE_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>

#include <atomic>
#include <cstddef>

namespace CGAL::Protrusion_segmentation::internal {

// What the execution of one of several tasks asks and tells that of all of them.
class Task_observer : public Observer
{
public:
  explicit Task_observer(Execution& all) : m_all(all) {}

  bool go_further() override
  {
    m_all.check(); // throws if not
    return true;
  }
  void stage_begins(Stage stage) override { m_all.observer().stage_begins(stage); }
  void stage_ends(Stage stage) override { m_all.observer().stage_ends(stage); }

private:
  Execution& m_all;
};

// Calls `body(i, execution)` for every i below `n`, if parallel in any order and each in one thread, with an execution of its own.
template <typename Body>
void for_each_side_by_side(std::size_t n, Execution& all, Body body)
{
  std::atomic<std::size_t> done{0};
  for_each_index(n, all.is_parallel(),
                 [&](std::size_t i)
                 {
                   Task_observer observer(all);
                   Execution execution(observer, all.random_seed(), false);
                   body(i, execution);
                   all.progress(static_cast<double>(++done) / static_cast<double>(n));
                 });
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_FOR_EACH_SIDE_BY_SIDE_H
