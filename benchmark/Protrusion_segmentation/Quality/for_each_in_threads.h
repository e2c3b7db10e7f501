// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_FOR_EACH_IN_THREADS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_FOR_EACH_IN_THREADS_H

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

// Calls `body(i)` for all i below `number`. An exception stops all threads, and is thrown again.
template <typename Body>
void for_each_in_threads(std::size_t number, std::size_t number_of_threads, Body body)
{
  std::atomic<std::size_t> next(0);
  std::mutex mutex;
  std::exception_ptr exception;
  const auto work = [&]()
  {
    try
    {
      for (std::size_t i; (i = next++) < number;)
        body(i);
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      exception = std::current_exception();
      next = number;
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < number_of_threads; ++t)
    threads.emplace_back(work);
  for (std::thread& thread : threads)
    thread.join();
  if (exception)
    std::rethrow_exception(exception);
}

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_FOR_EACH_IN_THREADS_H
