// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_EXECUTION_H
#define CGAL_PROTRUSION_SEGMENTATION_EXECUTION_H

#include <CGAL/Protrusion_segmentation/Segmentation_stopped.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Observer.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

What a model of `ProtrusionDistance` may know of the call of the package that uses it: the random seed, whether to use
several threads, and whether to go on. One object serves a whole call.
*/
class Execution
{
public:
  /// makes an execution of its own, to use a distance outside of a segmentation: nobody stops it.
  /// \param random_seed the seed of all that is random
  /// \param is_parallel whether several threads may be used
  explicit Execution(unsigned int random_seed = 0, bool is_parallel = false)
    : Execution(m_silent_observer, random_seed, is_parallel)
  {}
  Execution(const Execution&) = delete;
  Execution& operator=(const Execution&) = delete;

  /// \return the seed of all that is random; equal seeds give equal results
  unsigned int random_seed() const { return m_random_seed; }
  /// \return whether several threads may be used, by oneTBB
  bool is_parallel() const { return m_is_parallel; }

  /// asks the visitor whether to go on. To be called several times a second, from any thread.
  /// \throw Segmentation_stopped if the visitor stops the call of the package; distances must let it pass
  void check()
  {
    if (!is_own_thread()) // visitors are asked from the thread of the call only
    {
      if (m_is_cancelled)
        throw Segmentation_stopped();
    }
    else
      ask([this]()
          {
            if (!m_observer.go_further())
              throw Segmentation_stopped();
          });
  }

  /// tells how much is done of the work that was begun last, such as the preparation of a distance, and calls `check()`.
  /// \param share from 0 to 1
  /// \throw Segmentation_stopped as `check()`
  void progress(double share)
  {
    if (is_own_thread())
    {
      const double clamped = (std::min)((std::max)(share, 0.), 1.);
      m_share = (std::max)(m_share, m_begin + clamped * (m_end - m_begin));
      ask([this]() { m_observer.progress(m_share); });
    }
    check();
  }

#ifndef DOXYGEN_RUNNING
  Execution(internal::Observer& observer, unsigned int random_seed, bool is_parallel)
    : m_observer(observer), m_random_seed(random_seed), m_is_parallel(is_parallel)
  {}

  // of the thread of the call; other threads are not heard
  internal::Observer& observer() { return is_own_thread() ? m_observer : m_silent_observer; }

  // While it lives, progress from 0 to 1 is one from `begin` to `end` of the work begun before.
  class Subtask
  {
  public:
    Subtask(Execution& execution, double begin, double end)
      : m_execution(execution), m_begin(execution.m_begin), m_end(execution.m_end)
    {
      CGAL_assertion(execution.is_own_thread());
      const double length = m_end - m_begin;
      execution.m_begin = m_begin + begin * length;
      execution.m_end = m_begin + end * length;
    }
    ~Subtask()
    {
      m_execution.m_begin = m_begin;
      m_execution.m_end = m_end;
    }
    Subtask(const Subtask&) = delete;
    Subtask& operator=(const Subtask&) = delete;

  private:
    Execution& m_execution;
    double m_begin, m_end;
  };
#endif

private:
  // What a visitor throws ends the work of the other threads, too.
  template <typename Ask>
  void ask(Ask ask)
  {
    try
    {
      ask();
    }
    catch (...)
    {
      m_is_cancelled = true;
      throw;
    }
  }

  bool is_own_thread() const { return std::this_thread::get_id() == m_thread; }

  internal::Observer m_silent_observer;
  internal::Observer& m_observer;
  unsigned int m_random_seed;
  bool m_is_parallel;
  std::thread::id m_thread = std::this_thread::get_id();
  std::atomic<bool> m_is_cancelled{false};
  double m_begin = 0, m_end = 1, m_share = 0; // of the work begun last, of the whole
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_EXECUTION_H
