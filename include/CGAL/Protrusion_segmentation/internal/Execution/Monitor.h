// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_MONITOR_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_MONITOR_H

#include <CGAL/Protrusion_segmentation/Default_visitor.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <cstddef>
#include <exception>
#include <limits>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Thrown when a visitor stops a segmentation; caught by the public functions.
struct Cancelled {};

// What the stages of one call share: the visitor, the seed, and what turns lengths and faces of the surface
// into those of the mesh.
template <typename Visitor>
class Monitor
{
public:
  Monitor(Visitor& visitor,
          unsigned int random_seed,
          double unit,
          const std::vector<Indexed_surface::Index>& position)
    : m_visitor(visitor), m_random_seed(random_seed), m_unit(unit), m_position(position)
  {}

  Visitor& visitor() { return m_visitor; }
  unsigned int random_seed() const { return m_random_seed; }
  // the length in the mesh of a length 1 of the surface
  double unit() const { return m_unit; }
  // where a face of the surface is in the mesh
  std::size_t position(Indexed_surface::Index face) const { return m_position[face]; }

  void check()
  {
    if (!m_visitor.go_further())
      throw Cancelled();
  }
  // With no number requested, `unlimited()`, the share grows with every segment and never gets to 1.
  void progress(std::size_t found, std::size_t requested)
  {
    const double share = static_cast<double>(found);
    m_visitor.progress(requested == unlimited() ? share / (share + 1)
                                                : share / static_cast<double>(requested));
    check();
  }
  static constexpr std::size_t unlimited() { return (std::numeric_limits<std::size_t>::max)(); }

private:
  Visitor& m_visitor;
  unsigned int m_random_seed;
  double m_unit;
  const std::vector<Indexed_surface::Index>& m_position;
};

// Tells the visitor of the begin and, however the scope is left, of the end of a stage. An exception of the
// visitor gets through, unless the scope is left because of another one.
template <typename Visitor>
class Stage_scope
{
public:
  Stage_scope(Visitor& visitor, Stage stage)
    : m_visitor(visitor), m_stage(stage), m_number_of_exceptions(std::uncaught_exceptions())
  {
    m_visitor.stage_starts(stage);
  }
  ~Stage_scope() noexcept(false)
  {
    try
    {
      m_visitor.stage_ends(m_stage);
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
  Visitor& m_visitor;
  Stage m_stage;
  int m_number_of_exceptions;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_EXECUTION_MONITOR_H
