// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_GEODESIC_DISTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_GEODESIC_DISTANCE_H

#include <CGAL/Protrusion_segmentation/Surface_part.h>
#include <CGAL/Protrusion_segmentation/internal/largest_distance_sum.h>
#include <CGAL/Protrusion_segmentation/internal/shortest_distances.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationDistances

The geodesic distance GD of Section III.B.2: the length of the shortest path in the face dual graph.

The face of eq. (1) is found exactly, with a pruned search that needs a handful of shortest path
computations in place of one per face. One computation takes linear time in practice.

\cgalModels{ProtrusionDistance}
*/
class Geodesic_distance
{
public:
  /// the distances on one part
  /// \cgalModels{ProtrusionDistancesOnPart}
  class On_part
  {
  public:
    explicit On_part(const Surface_part& part) : m_part(part), m_shortest_distances(part) {}

    /// computes the distances from a face.
    /// \param source the face
    /// \param distances is filled with the distances of all faces
    void operator()(Surface_part::Index source, std::vector<double>& distances)
    {
      m_shortest_distances(source, distances);
    }
    /// computes the distances from a face up to a bound.
    /// \param source the face
    /// \param distances is filled with the distances of all faces; those above `bound` may be infinite
    /// \param bound the largest distance of interest
    void operator()(Surface_part::Index source, std::vector<double>& distances, double bound)
    {
      m_shortest_distances(source, distances, bound);
    }
    /// \return the face of eq. (1)
    Surface_part::Index face_of_largest_sum()
    {
      return internal::largest_distance_sum(m_part, m_shortest_distances);
    }
    /// \return how many shortest path computations there were so far
    std::size_t number_of_runs() const { return m_shortest_distances.number_of_runs(); }

  private:
    const Surface_part& m_part;
    internal::Shortest_distances m_shortest_distances;
  };

  /// prepares the distances on a connected part, in linear time.
  /// \param part the part, which must outlive the result
  /// \return the distances on it
  On_part on(const Surface_part& part, unsigned int /* random_seed */) const { return On_part(part); }
};

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_GEODESIC_DISTANCE_H
