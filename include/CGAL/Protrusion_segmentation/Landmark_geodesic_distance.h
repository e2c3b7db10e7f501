// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_LANDMARK_GEODESIC_DISTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_LANDMARK_GEODESIC_DISTANCE_H

#include <CGAL/Protrusion_segmentation/Surface_part.h>
#include <CGAL/Protrusion_segmentation/internal/largest_distance_sum.h>
#include <CGAL/Protrusion_segmentation/internal/select_landmarks.h>
#include <CGAL/Protrusion_segmentation/internal/shortest_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {

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
  /// the distances on one part
  /// \cgalModels{ProtrusionDistancesOnPart}
  class On_part
  {
  public:
    On_part(const Surface_part& part, std::size_t number_of_landmarks, unsigned int random_seed)
      : m_shortest_distances(part),
        m_to_landmark(part.number_of_faces(), internal::Shortest_distances::unreachable()),
        m_nearest(part.number_of_faces(), 0)
    {
      visit_landmarks(internal::select_landmarks(part.number_of_faces(), number_of_landmarks,
                                                 random_seed));
    }

    /// computes the distances from a face.
    /// \param source the face
    /// \param distances is filled with the distances of all faces
    void operator()(Surface_part::Index source, std::vector<double>& distances)
    {
      m_shortest_distances(m_nearest[source], distances);
      for (double& d : distances)
        d += m_to_landmark[source];
      distances[source] = 0;
    }

    /// \return the face of eq. (1)
    Surface_part::Index face_of_largest_sum() const { return m_face_of_largest_sum; }
    /// \return how many shortest path computations there were so far
    std::size_t number_of_runs() const { return m_shortest_distances.number_of_runs(); }

  private:
    // Steps 2 to 4: the distances from each landmark, the nearest landmark of every face, the sums.
    void visit_landmarks(const std::vector<Surface_part::Index>& landmarks)
    {
      using Index = Surface_part::Index;
      const Index n = static_cast<Index>(m_nearest.size());
      std::vector<double> from_landmark;
      std::vector<double> sum_of_nearest(n, 0);
      for (Index landmark : landmarks)
      {
        m_shortest_distances(landmark, from_landmark);
        const double sum = internal::distance_sum(from_landmark);
        for (Index f = 0; f < n; ++f)
          if (from_landmark[f] < m_to_landmark[f])
          {
            m_to_landmark[f] = from_landmark[f];
            m_nearest[f] = landmark;
            sum_of_nearest[f] = sum;
          }
      }
      // the sum from the landmark and the way to it for all other faces; less what the former holds for the
      // face itself, at distance 0
      for (Index f = 0; f < n; ++f)
        sum_of_nearest[f] += (n - 2.) * m_to_landmark[f];
      m_face_of_largest_sum = static_cast<Index>(
        std::max_element(sum_of_nearest.begin(), sum_of_nearest.end()) - sum_of_nearest.begin());
    }

    internal::Shortest_distances m_shortest_distances;
    std::vector<double> m_to_landmark;
    std::vector<Surface_part::Index> m_nearest;
    Surface_part::Index m_face_of_largest_sum = 0;
  };

  /// \return the share of the faces that the paper settles on, LGD(5)
  static constexpr double default_fraction() { return 0.05; }

  /// makes a share of the faces of each part landmarks.
  /// \param fraction the share, in (0, 1]; there is at least one landmark
  /// \throw std::invalid_argument unless 0 < `fraction` <= 1
  explicit Landmark_geodesic_distance(double fraction = default_fraction()) : m_fraction(fraction)
  {
    if (!(fraction > 0 && fraction <= 1))
      throw std::invalid_argument("Landmark_geodesic_distance: fraction is not in (0, 1]");
  }

  /// makes a fixed number of faces of each part landmarks.
  /// \param number the number, above 0; in a part that has fewer faces all are landmarks
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

  /// prepares the distances on a connected part, one shortest path computation per landmark.
  /// \param part the part, which must outlive the result
  /// \param random_seed of the choice of landmarks
  /// \return the distances on it
  On_part on(const Surface_part& part, unsigned int random_seed) const
  {
    const double share = std::ceil(m_fraction * part.number_of_faces());
    return On_part(part, m_number > 0 ? m_number : static_cast<std::size_t>(share), random_seed);
  }

private:
  double m_fraction;
  std::size_t m_number = 0; // 0: by fraction
};

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_LANDMARK_GEODESIC_DISTANCE_H
