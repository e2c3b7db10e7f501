// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops with a workspace for every thread: every index is visited once, by nested loops too, and workspaces are kept from one
// loop to the next.

#include "check.h"

#include <CGAL/Protrusion_segmentation/internal/Execution/Thread_workspaces.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <atomic>
#include <cstddef>
#include <vector>

using CGAL::Protrusion_segmentation::internal::Thread_workspaces;

// Counts what is done with it, and how many of it were made.
class Counting_workspace
{
public:
  explicit Counting_workspace(std::atomic<std::size_t>& made) : m_made(made) { ++m_made; }
  Counting_workspace(const Counting_workspace& other) : Counting_workspace(other.m_made) {}
  Counting_workspace& operator=(const Counting_workspace&) = delete;

  void work() { ++m_done; }
  std::size_t done() const { return m_done; }

private:
  std::atomic<std::size_t>& m_made;
  std::size_t m_done = 0;
};

std::size_t total(const Thread_workspaces<Counting_workspace>& workspaces)
{
  std::size_t sum = 0;
  workspaces.for_each([&](const Counting_workspace& workspace) { sum += workspace.done(); });
  return sum;
}

void check_all_once(const std::vector<std::atomic<int>>& visits)
{
  for (const std::atomic<int>& visit : visits)
    CGAL_CHECK_EQUAL(visit.load(), 1);
}

void every_index_comes_once(bool parallel, std::size_t most_threads)
{
  std::atomic<std::size_t> made(0);
  Thread_workspaces<Counting_workspace> workspaces(made);
  std::size_t expected = 0;
  for (std::size_t n : {0, 1, 2, 7, 1000})
  {
    std::vector<std::atomic<int>> visits(n);
    workspaces.for_each_index(n, parallel,
                              [&](Counting_workspace& workspace, std::size_t i)
                              {
                                workspace.work();
                                ++visits[i];
                              });
    check_all_once(visits);
    CGAL_CHECK_EQUAL(total(workspaces), expected += n);
  }
  CGAL_CHECK(made <= 1 + most_threads);
  CGAL_CHECK_EQUAL(workspaces.own().done(), parallel ? 0 : expected);
}

void loops_may_be_nested(bool parallel, std::size_t most_threads)
{
  std::atomic<std::size_t> made(0);
  Thread_workspaces<Counting_workspace> workspaces(made);
  std::vector<std::vector<std::size_t>> squares(30);
  workspaces.for_each_index(squares.size(), parallel,
                            [&](Counting_workspace&, std::size_t i)
                            {
                              squares[i].resize(i);
                              workspaces.for_each_index(i, parallel,
                                                        [&](Counting_workspace& workspace, std::size_t j)
                                                        {
                                                          workspace.work();
                                                          squares[i][j] = j * j;
                                                        });
                            });
  for (std::size_t i = 0; i < squares.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      CGAL_CHECK_EQUAL(squares[i][j], j * j);
  CGAL_CHECK_EQUAL(total(workspaces), 30u * 29 / 2);
  CGAL_CHECK(made <= 1 + most_threads);
}

void without_threads_indices_are_in_order()
{
  std::atomic<std::size_t> made(0);
  Thread_workspaces<Counting_workspace> workspaces(made);
  std::vector<std::size_t> order;
  workspaces.for_each_index(5, false, [&](Counting_workspace&, std::size_t i) { order.push_back(i); });
  CGAL_CHECK(order == (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  CGAL_CHECK_EQUAL(made.load(), 1u);
}

// An exception leaves the loop, and the workspaces serve the next one.
void exceptions_get_through(bool parallel)
{
  struct Of_body
  {};
  std::atomic<std::size_t> made(0);
  Thread_workspaces<Counting_workspace> workspaces(made);
  bool is_caught = false;
  try
  {
    workspaces.for_each_index(20, parallel,
                              [](Counting_workspace&, std::size_t i)
                              {
                                if (i == 7)
                                  throw Of_body();
                              });
  }
  catch (const Of_body&)
  {
    is_caught = true;
  }
  CGAL_CHECK(is_caught);
  workspaces.for_each_index(20, parallel,
                            [](Counting_workspace& workspace, std::size_t) { workspace.work(); });
  CGAL_CHECK_EQUAL(total(workspaces), 20u);
}

int main()
{
  without_threads_indices_are_in_order();
  exceptions_get_through(false);
  every_index_comes_once(false, 0);
  loops_may_be_nested(false, 0);
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t threads : {1, 2, 8})
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    every_index_comes_once(true, threads);
    loops_may_be_nested(true, threads);
    exceptions_get_through(true);
  }
#endif
  return check::result();
}
