// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_CHOSEN_METHOD_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_CHOSEN_METHOD_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace PS = CGAL::Protrusion_segmentation;

// A distance of any type: a model of ProtrusionDistance.
class Chosen_distance
{
public:
  class On_surface
  {
  public:
    explicit On_surface(std::unique_ptr<PS::internal::Distances_on_surface> distances)
      : m_distances(std::move(distances))
    {}

    void operator()(PS::Indexed_surface::Index source, std::vector<double>& distances, double bound)
    {
      (*m_distances)(source, distances, bound);
    }
    void operator()(PS::Indexed_surface::Index source, std::vector<double>& distances)
    {
      (*m_distances)(source, distances);
    }
    PS::Indexed_surface::Index face_of_largest_sum() { return m_distances->face_of_largest_sum(); }
    std::size_t number_of_runs() const { return m_distances->number_of_runs(); }

  private:
    std::unique_ptr<PS::internal::Distances_on_surface> m_distances;
  };

  explicit Chosen_distance(PS::internal::Any_distance distance) : m_distance(std::move(distance)) {}

  On_surface on(const PS::Indexed_surface& surface, PS::Execution& execution) const
  {
    return On_surface(m_distance.on(surface, execution));
  }

private:
  PS::internal::Any_distance m_distance;
};

// Arguments make sense: Python has checked them.
struct Method_options
{
  std::string method;                       // "minimum-cut" or "paper"
  std::string distance;                     // empty: that of the method
  std::optional<double> share_of_landmarks; // one of the two
  std::optional<std::size_t> number_of_landmarks;
  std::size_t number_of_terms = 0;
  double time = 0;
  double minimum_prominence = 0;
  bool uses_candidate_intervals = true;
  std::optional<Chosen_distance> own_distance; // in place of one with a name
};

// One of the package's methods, with a distance.
class Chosen_method
{
public:
  explicit Chosen_method(const Method_options& options);

  PS::internal::Nested_segments segment(const PS::Indexed_surface& surface,
                                        std::optional<std::size_t> number_of_segments,
                                        PS::Execution& execution) const
  {
    return m_segment(surface, number_of_segments, execution);
  }
  PS::internal::Nested_segments segment_from_tips(const PS::Indexed_surface& surface,
                                                  const std::vector<PS::Indexed_surface::Index>& tips,
                                                  PS::Execution& execution) const
  {
    return m_segment_from_tips(surface, tips, execution);
  }

private:
  template <typename Method>
  void set(const Method& method);

  std::function<
    PS::internal::Nested_segments(const PS::Indexed_surface&, std::optional<std::size_t>, PS::Execution&)>
    m_segment;
  std::function<PS::internal::Nested_segments(const PS::Indexed_surface&,
                                              const std::vector<PS::Indexed_surface::Index>&,
                                              PS::Execution&)>
    m_segment_from_tips;
};

// None if it is that of the method.
std::optional<Chosen_distance> choose_distance(const Method_options& options);

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_CHOSEN_METHOD_H
