// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Python module keeps threads that were interrupted until they are over, and no longer.

#include "Interrupted_threads.h"
#include "check.h"

#include <future>

namespace {

struct Test_thread
{
  std::promise<void> may_end;
  std::shared_ptr<std::atomic<bool>> is_over = std::make_shared<std::atomic<bool>>(false);

  std::thread start()
  {
    return std::thread(
      [end = may_end.get_future(), over = is_over]()
      {
        end.wait();
        *over = true;
      });
  }

  void end()
  {
    may_end.set_value();
    while (!*is_over)
      std::this_thread::yield();
  }
};

void threads_that_are_over_are_joined()
{
  python::Interrupted_threads threads;
  std::vector<Test_thread> all(4);
  for (Test_thread& thread : all)
    threads.add(thread.start(), thread.is_over);
  CGAL_CHECK_EQUAL(threads.number(), 4);
  all[0].end();
  all[2].end();
  Test_thread fifth, sixth;
  threads.add(fifth.start(), fifth.is_over);
  CGAL_CHECK_EQUAL(threads.number(), 3);
  fifth.end();
  all[1].end();
  all[3].end();
  threads.add(sixth.start(), sixth.is_over);
  CGAL_CHECK_EQUAL(threads.number(), 1);
  sixth.end();
}

} // namespace

int main()
{
  threads_that_are_over_are_joined();
  return check::result();
}
