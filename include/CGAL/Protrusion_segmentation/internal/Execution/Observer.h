// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_OBSERVER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_OBSERVER_H

#include <CGAL/Protrusion_segmentation/Protrusion.h>

#include <cstddef>
#include <cstdint>
#include <exception>

namespace CGAL::Protrusion_segmentation::internal {

enum class Stage
{
  READING,
  PREPARATION,
  TIPS,
  BORDERS,
  LABELS
};

// A visitor as the methods see it: faces are those of the surface, lengths in its unit. This one listens to
// nothing and never stops.
class Observer
{
public:
  using Index = std::uint32_t; // of a face, as in Indexed_surface

  virtual ~Observer() = default;
  virtual bool go_further() { return true; }
  virtual void progress(double /* share */) {}
  virtual void stage_begins(Stage) {}
  virtual void stage_ends(Stage) {}
  virtual void distances_computed(std::size_t /* number_of_runs */) {}
  virtual void tip_selected(Index /* face */) {}
  virtual void tip_eliminated(Index /* face */) {}
  // whether it matters what is told of tips and protrusions; what it takes to know more of them is saved if not
  virtual bool looks_at_protrusions() const { return false; }
  virtual void protrusion_found(const Protrusion<Index>&) {}
};

// Tells the observer of the begin and, however the scope is left, of the end of a stage. An exception of the
// visitor gets through, unless the scope is left because of another one.
class Stage_scope
{
public:
  Stage_scope(Observer& observer, Stage stage)
    : m_observer(observer), m_stage(stage), m_number_of_exceptions(std::uncaught_exceptions())
  {
    m_observer.stage_begins(stage);
  }
  ~Stage_scope() noexcept(false)
  {
    try
    {
      m_observer.stage_ends(m_stage);
    }
    catch (...)
    {
      if (std::uncaught_exceptions() == m_number_of_exceptions)
        throw;
    }
  }
  Stage_scope(const Stage_scope&) = delete;
  Stage_scope& operator=(const Stage_scope&) = delete;

private:
  Observer& m_observer;
  Stage m_stage;
  int m_number_of_exceptions;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_OBSERVER_H
