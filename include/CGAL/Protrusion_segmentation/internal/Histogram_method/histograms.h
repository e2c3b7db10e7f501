// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_HISTOGRAMS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_HISTOGRAMS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/plane_section.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Ten groups of ten intervals, Section III.D.1.
constexpr std::size_t number_of_slots = 100;

// The distance histogram of Section III.D.1: how many faces lie in each of the slots of equal width between
// the tip and the farthest face.
struct Distance_histogram
{
  double range = 0; // the distance of the farthest face
  std::array<Indexed_surface::Index, number_of_slots> counts{};

  Distance_histogram() = default;
  explicit Distance_histogram(const std::vector<double>& distances)
    : range(*std::max_element(distances.begin(), distances.end()))
  {
    for (double d : distances)
      ++counts[slot(d)];
  }

  std::size_t slot(double distance) const
  {
    if (!(range > 0))
      return 0;
    return (std::min)(static_cast<std::size_t>(number_of_slots * (distance / range)),
                      number_of_slots - 1);
  }
  // the share of the faces in the slots before a slot
  double share_before(std::size_t slot) const
  {
    const auto begin = counts.begin();
    return static_cast<double>(std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(slot), std::size_t(0))) /
           static_cast<double>(std::accumulate(begin, counts.end(), std::size_t(0)));
  }
  // the distance at which a slot begins
  double slot_begin(std::size_t slot) const { return range * static_cast<double>(slot) / number_of_slots; }
};

// The faces of each of the first slots.
class Slots
{
public:
  using Index = Indexed_surface::Index;

  explicit Slots(const std::vector<double>& distances) : Slots(distances, Distance_histogram(distances), number_of_slots) {}
  Slots(const std::vector<double>& distances, const Distance_histogram& histogram, std::size_t number)
    : m_faces(slots_of(distances, histogram, number), number + 1)
  {}

  std::size_t number() const { return m_faces.number_of_groups() - 1; }
  boost::iterator_range<const Index*> faces(std::size_t slot) const { return m_faces[slot]; }

private:
  // All that lies in a slot beyond `number` is in one group.
  static std::vector<Index> slots_of(const std::vector<double>& distances,
                                     const Distance_histogram& histogram,
                                     std::size_t number)
  {
    std::vector<Index> slot_of_face;
    slot_of_face.reserve(distances.size());
    for (double d : distances)
      slot_of_face.push_back(static_cast<Index>((std::min)(histogram.slot(d), number)));
    return slot_of_face;
  }

  Index_groups m_faces;
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
// faster than on average, and some slots around, because the contour is flat where the change begins.
inline std::vector<Slot_interval> candidate_intervals(const Distance_histogram& histogram)
{
  // the count of a slot on a mesh of a few thousand faces is noise over a width of one slot
  constexpr std::size_t smoothing_radius = 2;
  // half the width of the paper's groups of slots
  constexpr std::size_t margin = 5;
  std::array<double, number_of_slots> contour;
  std::copy(histogram.counts.begin(), histogram.counts.end(), contour.begin());
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

// The plane through the ring of faces in a slot: through the ring's centre of gravity, normal to the
// direction in which the distance grows there (the gradient over all arcs that leave a face of the ring).
inline Section_plane plane_of_slot(const Indexed_surface& surface,
                                   const std::vector<double>& distances,
                                   const Slots& tip_slots,
                                   std::size_t slot)
{
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;
  Vector_3 centre(0, 0, 0), growth(0, 0, 0);
  double area = 0;
  const Indexed_surface::Point_3 origin(0, 0, 0);
  for (Index f : tip_slots.faces(slot))
  {
    const Indexed_surface::Point_3 centroid = surface.centroid(f);
    area += surface.area(f);
    centre += surface.area(f) * (centroid - origin);
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      if (const Index g = surface.neighbor(c); g != Indexed_surface::no_face())
      {
        const Vector_3 arc = surface.centroid(g) - centroid;
        const double length = std::sqrt(arc.squared_length()); // as in the dual graph
        if (length > 0)
          growth += (surface.area(f) * (distances[g] - distances[f]) / (length * length)) * arc;
      }
  }
  return {area > 0 ? origin + centre / area : surface.centroid(tip_slots.faces(slot).front()), growth};
}

// The diameter of the component of the section that lies nearest to the centre of the ring; 0 if the plane
// crosses no face of the ring.
inline double diameter_of_slot(const Section_plane& plane,
                               const Slots& tip_slots,
                               std::size_t slot,
                               Plane_section& section)
{
  std::vector<Indexed_surface::Point_3> points, nearest_points;
  double nearest = (std::numeric_limits<double>::infinity)();
  section.start();
  for (Indexed_surface::Index f : tip_slots.faces(slot))
  {
    points.clear();
    section.component(f, plane, points);
    double distance = (std::numeric_limits<double>::infinity)();
    for (const Indexed_surface::Point_3& p : points)
      distance = (std::min)(distance, squared_distance(p, plane.origin));
    if (distance < nearest)
    {
      nearest = distance;
      nearest_points.swap(points);
    }
  }
  return planar_diameter(nearest_points, plane.normal);
}

// The sectional-diameter histogram of Section III.D.2: for each slot of the distance histogram the diameter
// of the surface's section there, in the unit of `surface`. A slot without a section takes the diameter of the
// slot before it. Slots that are not in `tip_slots` get 0.
inline std::array<double, number_of_slots> sectional_diameter_histogram(
  const Indexed_surface& surface,
  const std::vector<double>& distances,
  const Slots& tip_slots,
  Plane_section& section,
  Execution& execution)
{
  std::array<double, number_of_slots> diameters{};
  for_each_index(
    tip_slots.number(), execution.is_parallel(), section,
    [&](Plane_section& section_of_thread, std::size_t s)
    {
      execution.check();
      if (!tip_slots.faces(s).empty())
        diameters[s] = diameter_of_slot(plane_of_slot(surface, distances, tip_slots, s), tip_slots, s,
                                        section_of_thread);
    },
    [](const Plane_section&) {});
  for (std::size_t s = 1; s < tip_slots.number(); ++s)
    if (diameters[s] == 0)
      diameters[s] = diameters[s - 1];
  return diameters;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_HISTOGRAMS_H
