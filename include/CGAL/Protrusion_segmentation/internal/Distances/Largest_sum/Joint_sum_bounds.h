// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_SUM_JOINT_SUM_BOUNDS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_SUM_JOINT_SUM_BOUNDS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Upper bounds of the sums of eq. (1) by all visited faces together.
//
// A path from face i to face j may lead over any visited face c: d(i, j) <= d(i, c) + d(c, j). The best c differs from one j
// to the next. To choose it for every j would cost as much as the distances from i. Instead groups of faces that are near
// to each other choose together:
//   S(i) <= sum over all groups G of min over c of |G| d(i, c) + D(c, G),
// where D(c, G) is the sum of the distances from c to the faces of G. With some visited faces on all sides this is
// far closer than the bound of the best single one, for a small part of the time of a run of Dijkstra's algorithm.
class Joint_sum_bounds
{
public:
  using Index = Indexed_surface::Index;

  explicit Joint_sum_bounds(Index number_of_faces) : m_number_of_faces(number_of_faces)
  {
    for (Index group = 0; group < number_of_groups; ++group)
      m_sizes[group] = static_cast<float>(group_begin(group + 1) - group_begin(group));
  }

  // Takes the distances from one more visited face into account, while there is room.
  void add(const std::vector<double>& distances)
  {
    if (number_of_sources() == most_sources)
      return;
    if (number_of_sources() == 0)
      if (const double longest = *std::max_element(distances.begin(), distances.end()); longest > 0)
        m_unit = longest;
    std::vector<float>& rounded = m_distances.emplace_back();
    rounded.reserve(distances.size());
    Of_groups& sums = m_sums.emplace_back();
    for (Index group = 0; group < number_of_groups; ++group)
    {
      double sum = 0;
      for (Index f = group_begin(group); f < group_begin(group + 1); ++f)
      {
        sum += distances[f];
        rounded.push_back(static_cast<float>(distances[f] / m_unit));
      }
      sums[group] = static_cast<float>(sum / m_unit);
    }
  }

  std::size_t number_of_sources() const { return m_distances.size(); }

  // The face whose largest distance to a source is smallest; the lowest among equals.
  Index middle() const
  {
    std::vector<float> largest(m_number_of_faces, 0);
    for (const std::vector<float>& distances : m_distances)
      for (Index f = 0; f < m_number_of_faces; ++f)
        largest[f] = (std::max)(largest[f], distances[f]);
    return static_cast<Index>(std::min_element(largest.begin(), largest.end()) - largest.begin());
  }

  // The bound of a face, but for rounding in double precision; infinite without a source.
  double operator()(Index face) const
  {
    Of_groups best;
    best.fill((std::numeric_limits<float>::infinity)());
    for (std::size_t source = 0; source < number_of_sources(); ++source)
    {
      const float distance = m_distances[source][face];
      const Of_groups& sums = m_sums[source];
      for (Index group = 0; group < number_of_groups; ++group)
        best[group] = (std::min)(best[group], sums[group] + m_sizes[group] * distance);
    }
    std::array<double, 4> sums{}; // that do not wait for each other
    for (Index group = 0; group < number_of_groups; group += sums.size())
      for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] += best[group + k];
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) * rounding_of_floats * m_unit;
  }

private:
  // Faces are in the order of a curve that fills space, so that runs of them are near to each other. With half as
  // many groups there were more visits, with twice as many 1 % fewer, which took longer. Groups of few faces may be empty.
  static constexpr Index number_of_groups = 128;
  using Of_groups = std::array<float, number_of_groups>;

  // On twelve Princeton models the search takes 2157 visits with 16 sources and 2319 with 8. Each source takes four bytes a
  // face.
  static constexpr std::size_t most_sources = 12;
  // Four operations are rounded, by half an epsilon each; the factor has room for eight.
  static constexpr double rounding_of_floats = 1 + 4 * (std::numeric_limits<float>::epsilon)();

  Index group_begin(Index group) const
  {
    return static_cast<Index>(std::size_t(m_number_of_faces) * group / number_of_groups);
  }

  Index m_number_of_faces;
  double m_unit = 1; // of all floats, so that none is too large or too small for one
  Of_groups m_sizes; // |G|
  std::vector<std::vector<float>> m_distances; // d(i, c) by c and i
  std::vector<Of_groups> m_sums;               // D(c, G) by c and G
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_LARGEST_SUM_JOINT_SUM_BOUNDS_H
