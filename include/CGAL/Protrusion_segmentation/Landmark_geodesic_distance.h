// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_LANDMARK_GEODESIC_DISTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_LANDMARK_GEODESIC_DISTANCE_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/landmarks.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationDistances

The landmark-based geodesic distance LGD of Section III.B.3.

Landmarks are faces drawn at random. The distance from face <i>i</i> to face <i>j</i> is the geodesic
distance from <i>i</i> to its nearest landmark <i>l</i>(<i>i</i>) plus the geodesic distance from that
landmark to <i>j</i> (and 0 for <i>i</i> = <i>j</i>). The sums of eq. (1) then need one shortest path
computation per landmark in place of one per face.

It is here for the sake of the paper: `Geodesic_distance` finds the exact face in less time. Since the
distance to the nearest landmark is counted once for every face <i>j</i>, the face of eq. (1) drifts into
the largest gap between the landmarks.

\cgalModels{ProtrusionDistance}
*/
class Landmark_geodesic_distance
{
public:
  /// the distances on one surface
  /// \cgalModels{ProtrusionDistancesOnSurface}
  class On_surface
  {
  public:
    /// prepares the distances on a surface, one shortest path computation per landmark.
    /// \param surface the surface, which must outlive the object
    /// \param number_of_landmarks the number of landmarks, above 0
    /// \param execution with the seed of their choice, and asked whether to go on
    On_surface(const Indexed_surface& surface, std::size_t number_of_landmarks, Execution& execution)
      : m_shortest_distances(surface), m_nearest(surface)
    {
      visit_landmarks(internal::select_landmarks(surface.number_of_faces(), number_of_landmarks,
                                                 execution.random_seed()),
                      execution);
    }

    /// computes the distances from a face.
    /// \param source the face
    /// \param distances is filled with the distances of all faces
    void operator()(Indexed_surface::Index source, std::vector<double>& distances)
    {
      m_shortest_distances(m_landmarks[m_nearest.landmark(source)], distances);
      for (double& d : distances)
        d += m_nearest.distance(source);
      distances[source] = 0;
    }

    /// \return the face of eq. (1)
    Indexed_surface::Index face_of_largest_sum() const { return m_face_of_largest_sum; }
    /// \return how many shortest path computations there were so far
    std::size_t number_of_runs() const
    {
      return m_landmarks.size() + m_shortest_distances.number_of_runs();
    }

  private:
    // Steps 2 to 4: the distances from each landmark, the nearest landmark of every face, the sums.
    void visit_landmarks(std::vector<Indexed_surface::Index> landmarks, Execution& execution)
    {
      m_landmarks = std::move(landmarks);
      std::vector<double> sums(m_landmarks.size());
      struct Workspace
      {
        internal::Shortest_distances shortest_distances;
        internal::Nearest_landmarks nearest;
        std::vector<double> from_landmark;
      };
      Workspace workspace = {m_shortest_distances, m_nearest, {}};
      internal::for_each_index(
        m_landmarks.size(), execution.is_parallel(), workspace,
        [&](Workspace& w, std::size_t i)
        {
          execution.progress(static_cast<double>(i) / static_cast<double>(m_landmarks.size()));
          w.shortest_distances(m_landmarks[i], w.from_landmark);
          sums[i] = internal::distance_sum(w.from_landmark);
          w.nearest.add(static_cast<Indexed_surface::Index>(i), w.from_landmark);
        },
        [this](const Workspace& w) { m_nearest.add(w.nearest); });
      find_largest_sum(sums);
    }

    // The sum from the landmark and the way to it for all other faces; less what the former holds for the
    // face itself, at distance 0.
    void find_largest_sum(const std::vector<double>& sums)
    {
      double largest = -1;
      const Indexed_surface::Index n = m_nearest.number_of_faces();
      for (Indexed_surface::Index f = 0; f < n; ++f)
      {
        const double sum = sums[m_nearest.landmark(f)] + (n - 2.) * m_nearest.distance(f);
        if (sum > largest)
        {
          largest = sum;
          m_face_of_largest_sum = f;
        }
      }
    }

    internal::Shortest_distances m_shortest_distances;
    internal::Nearest_landmarks m_nearest;
    std::vector<Indexed_surface::Index> m_landmarks;
    Indexed_surface::Index m_face_of_largest_sum = 0;
  };

  /// \return the share of the faces that the paper settles on, LGD(5)
  static constexpr double default_fraction() { return 0.05; }

  /// makes a share of the faces of each surface landmarks.
  /// \param fraction the share, in (0, 1]; there is at least one landmark
  /// \throw std::invalid_argument unless 0 < `fraction` <= 1
  explicit Landmark_geodesic_distance(double fraction = default_fraction()) : m_fraction(fraction)
  {
    if (!(fraction > 0 && fraction <= 1))
      throw std::invalid_argument("Landmark_geodesic_distance: fraction is not in (0, 1]");
  }

  /// makes a fixed number of faces of each surface landmarks.
  /// \param number the number, above 0; on a surface that has fewer faces all are landmarks
  /// \return the distance
  /// \throw std::invalid_argument if `number` is 0
  static Landmark_geodesic_distance with_number_of_landmarks(std::size_t number)
  {
    if (number == 0)
      throw std::invalid_argument("Landmark_geodesic_distance: number of landmarks is 0");
    Landmark_geodesic_distance distance;
    distance.m_number = number;
    return distance;
  }

  /// prepares the distances on a connected surface, one shortest path computation per landmark, by several
  /// threads if `execution` wants so, with the same result.
  /// \param surface the surface, which must outlive the result
  /// \param execution with the seed of the choice of landmarks, and asked whether to go on
  /// \return the distances on it
  On_surface on(const Indexed_surface& surface, Execution& execution) const
  {
    const double share = std::ceil(m_fraction * surface.number_of_faces());
    return On_surface(surface, m_number > 0 ? m_number : static_cast<std::size_t>(share), execution);
  }

private:
  double m_fraction;
  std::size_t m_number = 0; // 0: by fraction
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_LANDMARK_GEODESIC_DISTANCE_H
