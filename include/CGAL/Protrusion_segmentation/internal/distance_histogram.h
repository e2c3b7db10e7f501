// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCE_HISTOGRAM_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCE_HISTOGRAM_H

#include <CGAL/Protrusion_segmentation/Surface_part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Ten groups of ten intervals, Section III.D.1.
constexpr std::size_t number_of_slots = 100;

// The distance histogram of Section III.D.1: the range from the tip to the farthest face in slots of equal
// width, each with the faces at that distance.
class Distance_histogram
{
public:
  using Index = Surface_part::Index;

  explicit Distance_histogram(const std::vector<double>& distances)
    : m_range(*std::max_element(distances.begin(), distances.end())),
      m_faces(distances.size())
  {
    m_begin.fill(0);
    for (double d : distances)
      ++m_begin[slot(d) + 1];
    for (std::size_t s = 0; s < number_of_slots; ++s)
      m_begin[s + 1] += m_begin[s];
    std::array<Index, number_of_slots + 1> position = m_begin;
    for (Index f = 0; f < distances.size(); ++f)
      m_faces[position[slot(distances[f])]++] = f;
  }

  double range() const { return m_range; }
  std::size_t slot(double distance) const
  {
    if (!(m_range > 0))
      return 0;
    return (std::min)(static_cast<std::size_t>(number_of_slots * (distance / m_range)),
                      number_of_slots - 1);
  }
  // the distance at which a slot begins
  double slot_begin(std::size_t slot) const
  {
    return m_range * static_cast<double>(slot) / number_of_slots;
  }
  std::size_t count(std::size_t slot) const { return m_begin[slot + 1] - m_begin[slot]; }
  const Index* faces_begin(std::size_t slot) const { return m_faces.data() + m_begin[slot]; }
  const Index* faces_end(std::size_t slot) const { return m_faces.data() + m_begin[slot + 1]; }

private:
  double m_range;
  std::array<Index, number_of_slots + 1> m_begin;
  std::vector<Index> m_faces; // slot by slot
};

// Slots from `first` to `last`, both included.
struct Slot_interval
{
  std::size_t first;
  std::size_t last;
};

// The mean of every value and its neighbours up to `radius` slots away.
inline std::array<double, number_of_slots> moving_average(
  const std::array<double, number_of_slots>& values, std::size_t radius)
{
  std::array<double, number_of_slots> result;
  for (std::size_t s = 0; s < number_of_slots; ++s)
  {
    const std::size_t first = s < radius ? 0 : s - radius;
    const std::size_t last = (std::min)(s + radius, number_of_slots - 1);
    double sum = 0;
    for (std::size_t i = first; i <= last; ++i)
      sum += values[i];
    result[s] = sum / static_cast<double>(last - first + 1);
  }
  return result;
}

// The candidate intervals of Section III.D.3: where the smoothed contour of the histogram rises or falls
// faster than on average, and `margin` slots around, because the contour is flat where the change begins.
inline std::vector<Slot_interval> candidate_intervals(const Distance_histogram& histogram,
                                                      std::size_t margin)
{
  // the count of a slot on a mesh of a few thousand faces is noise over a width of one slot
  constexpr std::size_t smoothing_radius = 2;
  std::array<double, number_of_slots> contour;
  for (std::size_t s = 0; s < number_of_slots; ++s)
    contour[s] = static_cast<double>(histogram.count(s));
  contour = moving_average(contour, smoothing_radius);

  std::array<double, number_of_slots> slope{};
  double mean_slope = 0;
  for (std::size_t s = 1; s + 1 < number_of_slots; ++s)
  {
    slope[s] = std::abs(contour[s + 1] - contour[s - 1]) / 2;
    mean_slope += slope[s] / number_of_slots;
  }
  std::vector<Slot_interval> intervals;
  for (std::size_t s = 1; s + 1 < number_of_slots; ++s)
    if (slope[s] > mean_slope)
    {
      const Slot_interval window = {s < margin ? 0 : s - margin,
                                    (std::min)(s + margin, number_of_slots - 1)};
      if (!intervals.empty() && window.first <= intervals.back().last + 1)
        intervals.back().last = window.last;
      else
        intervals.push_back(window);
    }
  return intervals;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCE_HISTOGRAM_H
