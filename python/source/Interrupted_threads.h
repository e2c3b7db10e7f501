// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_INTERRUPTED_THREADS_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_INTERRUPTED_THREADS_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace python {

// Threads that were interrupted and have still to notice it, which takes them up to some seconds on a large mesh. The
// process may not end before them: they use what it destroys then.
class Interrupted_threads
{
public:
  ~Interrupted_threads()
  {
    for (Thread& thread : m_threads)
      thread.thread.join();
  }

  // `is_over` becomes true when the thread has nothing more to do. Threads for which it is true are joined.
  void add(std::thread thread, std::shared_ptr<const std::atomic<bool>> is_over)
  {
    const auto first_over = std::partition(m_threads.begin(), m_threads.end(),
                                           [](const Thread& other) { return !*other.is_over; });
    std::for_each(first_over, m_threads.end(), [](Thread& other) { other.thread.join(); });
    m_threads.erase(first_over, m_threads.end());
    m_threads.push_back({std::move(thread), std::move(is_over)});
  }

  std::size_t number() const { return m_threads.size(); }

  // in a process that was forked, which has none of them
  void forget()
  {
    for (Thread& thread : m_threads)
      thread.thread.detach();
    m_threads.clear();
  }

private:
  struct Thread
  {
    std::thread thread;
    std::shared_ptr<const std::atomic<bool>> is_over;
  };

  std::vector<Thread> m_threads;
};

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_INTERRUPTED_THREADS_H
