// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_DETECT_BORDER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_DETECT_BORDER_H

#include <CGAL/Protrusion_segmentation/internal/Histogram_method/distance_histogram.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// An inflection point of the sectional-diameter histogram.
struct Inflection
{
  std::size_t slot;  // where the diameter grows fastest
  double prominence; // log of the ratio of the diameters `width` slots apart around it
};

// The inflection points of Section III.D.2, the most prominent first. A window of `width` slots is one if
// the diameter grows over it by a larger factor than over any other window that begins less than `width`
// slots away. Windows before `first_slot` belong to the cap of the protrusion, where the diameter grows
// from nothing.
//
// The paper gives no constants. On half of the development models of the Princeton benchmark a width of 5
// slots was better than 3 or 8, and a first slot of 12 (Rand index error .197) than 5 (.232) or 8 (.218).
struct Inflection_windows
{
  static constexpr std::size_t width = 5;
  static constexpr std::size_t first_slot = 12;
  static constexpr std::size_t smoothing_radius = 1; // enough against sections that miss a few faces

  // How many slots must be known to tell whether a window that begins at a slot is one: the last window that it is compared
  // with begins `width` - 1 slots later.
  static std::size_t slots_for(std::size_t slot)
  {
    return (std::min)(slot + (width - 1) + width + smoothing_radius + 1, number_of_slots);
  }
};

// If only the diameters of the first slots are known, these are the ones that they suffice for.
inline std::vector<Inflection> inflection_points(const std::array<double, number_of_slots>& diameters,
                                                 std::size_t number_of_diameters = number_of_slots)
{
  constexpr std::size_t width = Inflection_windows::width, first_slot = Inflection_windows::first_slot;
  const std::array<double, number_of_slots> smooth = moving_average(diameters, Inflection_windows::smoothing_radius);
  const auto growth_over = [&smooth](std::size_t slot, std::size_t slots)
  { return smooth[slot] > 0 ? std::log(smooth[slot + slots] / smooth[slot]) : 0.; };

  std::array<double, number_of_slots> growth{};
  for (std::size_t s = first_slot; s + width < (std::min)(number_of_diameters, number_of_slots); ++s)
    growth[s] = growth_over(s, width);
  std::vector<Inflection> result;
  for (std::size_t s = first_slot; s + width < number_of_slots; ++s)
  {
    if (Inflection_windows::slots_for(s) > number_of_diameters)
      break;
    const auto window = growth.begin() + static_cast<std::ptrdiff_t>(s);
    const auto before = growth.begin() + static_cast<std::ptrdiff_t>(s < width ? 0 : s - width + 1);
    const auto after = window + static_cast<std::ptrdiff_t>((std::min)(width, number_of_slots - s));
    if (!(growth[s] > 0) || std::max_element(before, after) != window)
      continue;
    Inflection inflection = {s, growth[s]};
    for (std::size_t t = s; t < s + width; ++t)
      if (growth_over(t, 1) > growth_over(inflection.slot, 1))
        inflection.slot = t;
    result.push_back(inflection);
  }
  std::stable_sort(result.begin(), result.end(), [](const Inflection& a, const Inflection& b)
                   { return a.prominence > b.prominence; });
  return result;
}

inline bool contains(const std::vector<Slot_interval>& intervals, std::size_t slot)
{
  return std::any_of(intervals.begin(), intervals.end(), [slot](const Slot_interval& interval)
                     { return interval.first <= slot && slot <= interval.last; });
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_DETECT_BORDER_H
