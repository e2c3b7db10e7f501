// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_RUN_INTERRUPTIBLY_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_RUN_INTERRUPTIBLY_H

#include "Interrupted_threads.h"
#include "Watcher.h"

#include <CGAL/Protrusion_segmentation/Segmentation_stopped.h>

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <type_traits>
#include <utility>

namespace python {

inline Interrupted_threads& interrupted_threads()
{
  static Interrupted_threads threads;
  return threads;
}

// The calls that are under way. Python ends a thread that asks for the GIL after the interpreter, as daemon threads do, and
// C++ ends the process then; so all calls of other threads have to be over before.
class Calls
{
public:
  // One call, from its beginning to its end. Made with the GIL, which is what keeps the calls from each other.
  class Call
  {
  public:
    Call(Calls& calls, std::atomic<bool>& is_stopped) : m_calls(calls), m_is_stopped(is_stopped)
    {
      m_calls.exit_if_ended();
      const std::lock_guard<std::mutex> lock(m_calls.m_mutex);
      m_calls.m_under_way.insert(&m_is_stopped);
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    ~Call()
    {
      const std::lock_guard<std::mutex> lock(m_calls.m_mutex);
      m_calls.m_under_way.erase(&m_is_stopped);
      m_calls.m_one_is_over.notify_all();
    }

  private:
    Calls& m_calls;
    std::atomic<bool>& m_is_stopped;
  };

  // Stops all calls, and waits until they are over. The thread that runs this may begin others.
  void end()
  {
    m_ending_thread = std::this_thread::get_id();
    m_is_ended = true;
    const pybind11::gil_scoped_release released;
    std::unique_lock<std::mutex> lock(m_mutex);
    for (std::atomic<bool>* const is_stopped : m_under_way)
      *is_stopped = true;
    m_one_is_over.wait(lock, [this]() { return m_under_way.empty(); });
  }

  // in a process that was forked, which has none of them
  void forget() { m_under_way.clear(); }

  // With the GIL: ends the thread that asks, as Python does without a word, if the interpreter is about to end.
  void exit_if_ended() const
  {
    if (!m_is_ended || std::this_thread::get_id() == m_ending_thread)
      return;
    PyErr_SetNone(PyExc_SystemExit);
    throw pybind11::error_already_set();
  }

private:
  std::mutex m_mutex;
  std::condition_variable m_one_is_over;
  std::set<std::atomic<bool>*> m_under_way;
  bool m_is_ended = false;
  std::thread::id m_ending_thread;
};

inline Calls& calls()
{
  static Calls calls;
  return calls;
}

// People feel no delay below a tenth of a second; a look takes microseconds.
constexpr std::chrono::milliseconds time_between_looks_for_signals{50};

// With the GIL: true if the handler of a signal raised an exception of Python before the result was there.
template <typename Result>
bool is_interrupted_before(const std::future<Result>& result)
{
  const pybind11::gil_scoped_release released;
  while (result.wait_for(time_between_looks_for_signals) != std::future_status::ready)
  {
    const pybind11::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0)
      return true;
  }
  return false;
}

// The result of `run(watcher)`, which runs in a thread of its own: so Ctrl-C is answered at once, also where nobody
// asks the watcher. `run` must own all that it uses, for after Ctrl-C it is left alone; it knows nothing of Python.
template <typename Run>
auto run_interruptibly(Run run)
{
  const auto is_stopped = std::make_shared<std::atomic<bool>>(false);
  const Calls::Call call(calls(), *is_stopped);
  std::packaged_task<std::invoke_result_t<Run&, Watcher&>()> task(
    [run = std::move(run), is_stopped]() mutable
    {
      Watcher watcher([&]() { return !*is_stopped; });
      return run(watcher);
    });
  auto result = task.get_future();
  interrupted_threads(); // lives longer than the thread
  const auto is_over = std::make_shared<std::atomic<bool>>(false);
  std::thread thread(
    [task = std::move(task), is_over]() mutable
    {
      task();
      *is_over = true;
    });
  if (is_interrupted_before(result))
  {
    *is_stopped = true;
    interrupted_threads().add(std::move(thread), is_over);
    throw pybind11::error_already_set();
  }
  thread.join();
  calls().exit_if_ended();
  return result.get();
}

// The same in the thread of the call, for what calls functions of Python, such as `progress`. They may end it by an exception. So
// may the handler of a signal, which is looked for whenever the watcher is asked.
template <typename Run>
auto run_with_callbacks(Run run, const std::function<void(double)>& progress)
{
  using Clock = std::chrono::steady_clock;
  std::atomic<bool> is_stopped(false);
  const Calls::Call call(calls(), is_stopped);
  Clock::time_point last_look = Clock::now();
  Watcher watcher(
    [&]()
    {
      if (Clock::now() - last_look >= time_between_looks_for_signals)
      {
        const pybind11::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0)
          throw pybind11::error_already_set();
        last_look = Clock::now();
      }
      return !is_stopped;
    },
    progress);
  std::optional<std::invoke_result_t<Run&, Watcher&>> result;
  try
  {
    const pybind11::gil_scoped_release released;
    result = run(watcher);
  }
  catch (const CGAL::Protrusion_segmentation::Segmentation_stopped&)
  {} // the process ends
  calls().exit_if_ended();
  return std::move(result.value());
}

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_RUN_INTERRUPTIBLY_H
