// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_JOINT_SUM_BOUNDS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_JOINT_SUM_BOUNDS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/sum_of_terms.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Upper bounds of the sums of eq. (1) by all visited faces together.
//
// A path from face i to face j may lead over any visited face c, d(i, j) <= d(i, c) + d(c, j), over another one for
// each j: over one that lies on the way. To choose it for every j would cost as much as the distances from i. Instead
// groups of faces that are near to each other choose together:
//   S(i) <= sum over all groups G of min over c of |G| d(i, c) + D(c, G),
// where D(c, G) is the sum of the distances from c to the faces of G. With some visited faces on all sides this is
// far closer than what the best one of them says alone, for a small part of the time of a run of Dijkstra's algorithm.
class Joint_sum_bounds
{
public:
  using Index = Indexed_surface::Index;

  explicit Joint_sum_bounds(Index number_of_faces)
    : m_number_of_faces(number_of_faces),
      m_number_of_groups((std::min)(number_of_faces, most_groups)),
      m_best(m_number_of_groups)
  {
    for (Index group = 0; group < m_number_of_groups; ++group)
      m_sizes.push_back(static_cast<float>(group_begin(group + 1) - group_begin(group)));
  }

  // Takes the distances from one more visited face into account, while there is room; `longest` is the longest of them.
  void add(const std::vector<double>& distances, double longest)
  {
    if (number_of_sources() == most_sources)
      return;
    if (number_of_sources() == 0 && longest > 0)
      m_scale = longest;
    m_units.push_back(longest / most_units);
    const double units_per_length = longest > 0 ? most_units / longest : 0;
    m_distances.emplace_back(distances.size());
    m_sums.emplace_back();
    for (Index group = 0; group < m_number_of_groups; ++group)
    {
      double sum = 0;
      for (Index f = group_begin(group); f < group_begin(group + 1); ++f)
      {
        sum += distances[f];
        m_distances.back()[f] = static_cast<Rounded>(distances[f] * units_per_length + 1);
      }
      m_sums.back().push_back(static_cast<float>(sum / m_scale));
    }
  }

  std::size_t number_of_sources() const { return m_distances.size(); }

  // The face whose largest distance to a source is smallest; the lowest among equals.
  Index middle() const
  {
    Index result = 0;
    double smallest = (std::numeric_limits<double>::infinity)();
    for (Index f = 0; f < m_number_of_faces; ++f)
    {
      double largest = 0;
      for (std::size_t source = 0; source < number_of_sources(); ++source)
        largest = (std::max)(largest, m_distances[source][f] * m_units[source]);
      if (largest < smallest)
      {
        smallest = largest;
        result = f;
      }
    }
    return result;
  }

  // The bound of a face, but for rounding in double precision; infinite without a source.
  double operator()(Index face)
  {
    std::fill(m_best.begin(), m_best.end(), (std::numeric_limits<float>::infinity)());
    for (std::size_t source = 0; source < number_of_sources(); ++source)
    {
      const float distance = static_cast<float>(m_distances[source][face] * m_units[source] / m_scale);
      const float* const sums = m_sums[source].data();
      for (std::size_t group = 0; group < m_best.size(); ++group)
        m_best[group] = (std::min)(m_best[group], sums[group] + m_sizes[group] * distance);
    }
    return sum_of_terms(m_best.size(), [this](std::size_t group) { return m_best[group]; }) * rounding_of_floats * m_scale;
  }

private:
  // Faces are in the order of a curve that fills space, so that runs of them are near to each other. With half as
  // many groups there were more visits, with twice as many 1 % fewer, which took longer.
  static constexpr Index most_groups = 128;
  // With 8, 16 and 64 sources the search on parts of Princeton models took 4320, 4103 and 4023 visits, with none 7006.
  static constexpr std::size_t most_sources = 16;

  // Distances are rounded up to multiples of a small unit, so that they take two bytes.
  using Rounded = std::uint16_t;
  static constexpr double most_units = (std::numeric_limits<Rounded>::max)() - 1;

  // Sums take four bytes, so that twice as many are added and compared at once. Of eight operations that may be rounded four are.
  static constexpr double rounding_of_floats = 1 + 4 * (std::numeric_limits<float>::epsilon)();

  Index group_begin(Index group) const
  {
    return static_cast<Index>(std::size_t(m_number_of_faces) * group / m_number_of_groups);
  }

  Index m_number_of_faces;
  Index m_number_of_groups;
  double m_scale = 1; // what is kept as float is in units of it, so that none is too large or small for that
  std::vector<float> m_sizes;                    // |G|
  std::vector<double> m_units;                   // by c
  std::vector<std::vector<Rounded>> m_distances; // d(i, c) by c and i, in units
  std::vector<std::vector<float>> m_sums;        // D(c, G) by c and G
  std::vector<float> m_best;                     // of every group, for one face
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_JOINT_SUM_BOUNDS_H
