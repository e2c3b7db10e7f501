// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_GEODESIC_DISTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_GEODESIC_DISTANCE_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationDistances

The geodesic distance GD of Section III.B.2: the length of the shortest path in the face dual graph.

The face of eq. (1) is found exactly. Upper bounds of the sums of distances rule out most faces, so that few shortest path
computations are needed: 5 to 20 for surfaces with protrusions, and hundreds for round ones, for which their number is
limited. One computation takes linear time in practice.

\cgalModels{ProtrusionDistance}
*/
class Geodesic_distance
{
public:
  /// the distances on one surface
  /// \cgalModels{ProtrusionDistancesOnSurface}
  class On_surface
  {
  public:
    /// prepares the distances on a surface.
    /// \param surface the surface, which must outlive the object
    /// \param maximum_number_of_visits see `Geodesic_distance::maximum_number_of_visits()`
    /// \param execution asked whether to go on, which must outlive the object
    On_surface(const Indexed_surface& surface,
               std::size_t maximum_number_of_visits,
               Execution& execution)
      : m_surface(surface),
        m_maximum_number_of_visits(maximum_number_of_visits),
        m_execution(execution),
        m_shortest_distances(surface)
    {}

    /// computes the distances from a face.
    /// \param source the face
    /// \param distances is filled with the distances of all faces
    void operator()(Indexed_surface::Index source, std::vector<double>& distances)
    {
      (*this)(source, distances, internal::Shortest_distances::unreachable());
    }
    /// computes the distances from a face up to a bound.
    /// \param source the face
    /// \param distances is filled with the distances of all faces; those above `bound` may be infinite
    /// \param bound the largest distance of interest
    void operator()(Indexed_surface::Index source, std::vector<double>& distances, double bound)
    {
      if (source == m_kept_source && !m_kept.empty())
        distances = std::exchange(m_kept, {});
      else
        m_shortest_distances(source, distances, bound);
    }
    /// \return the face of eq. (1)
    Indexed_surface::Index face_of_largest_sum()
    {
      internal::Largest_distance_sum<internal::Shortest_distances> search(m_surface, m_shortest_distances, m_execution);
      m_kept_source = search(m_maximum_number_of_visits);
      m_kept = search.take_distances_from_best();
      return m_kept_source;
    }
    /// \return how many shortest path computations there were so far
    std::size_t number_of_runs() const { return m_shortest_distances.number_of_runs(); }

  private:
    const Indexed_surface& m_surface;
    std::size_t m_maximum_number_of_visits;
    Execution& m_execution;
    internal::Shortest_distances m_shortest_distances;
    // the distances of the face of eq. (1) are asked for next
    Indexed_surface::Index m_kept_source = 0;
    std::vector<double> m_kept;
  };

  /// \return the largest number of faces from which the search for the face of eq. (1) computes shortest paths, above
  ///         0. Then it takes the best face so far. Default: no value, which means twenty million divided by the number
  ///         of faces of the surface, but at least 100. Only large round surfaces reach it; on spheres and tori of up to a
  ///         million faces, the sum of the face that was taken is within 5 % of the largest.
  std::optional<std::size_t> maximum_number_of_visits() const { return m_maximum_number_of_visits; }
  /// sets the number of faces that the search for the face of eq. (1) may visit.
  /// \param value the number, above 0; the number of faces makes the search exact on every surface
  /// \return `*this`
  /// \throw std::invalid_argument if `value` is 0
  Geodesic_distance& maximum_number_of_visits(std::size_t value)
  {
    if (value == 0)
      throw std::invalid_argument("Geodesic_distance: maximum_number_of_visits is 0, but it must be at least 1");
    m_maximum_number_of_visits = value;
    return *this;
  }

  /// prepares the distances on a connected surface, in linear time.
  /// \param surface the surface, which must outlive the result
  /// \param execution asked whether to go on, which must outlive the result
  /// \return the distances on it
  On_surface on(const Indexed_surface& surface, Execution& execution) const
  {
    return On_surface(surface, m_maximum_number_of_visits.value_or(visits_by_default(surface.number_of_faces())), execution);
  }

private:
  // Parts of Princeton models with 28 thousand faces take up to 239 visits; surfaces with protrusions and a million faces take
  // up to 60, a torus takes more than 1000.
  static constexpr std::size_t faces_of_all_visits = 20000000;
  static constexpr std::size_t least_visits = 100;

  static std::size_t visits_by_default(std::size_t number_of_faces)
  {
    return (std::max)(least_visits, faces_of_all_visits / (std::max)(number_of_faces, std::size_t(1)));
  }

  std::optional<std::size_t> m_maximum_number_of_visits;
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_GEODESIC_DISTANCE_H
