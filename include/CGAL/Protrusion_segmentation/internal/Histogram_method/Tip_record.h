// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_TIP_RECORD_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_TIP_RECORD_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Protrusion.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/histograms.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/plane_section.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

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
  const auto growth_over = [&smooth](std::size_t slot, std::size_t number)
  { return smooth[slot] > 0 ? std::log(smooth[slot + number] / smooth[slot]) : 0.; };

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

// What is kept of the distances from a tip: enough to decide on its border at any later time.
struct Tip_record
{
  Indexed_surface::Index tip; // face of the segment
  bool is_plausible;          // else to be used only when no plausible tip has a border
  Distance_histogram histogram;
  std::vector<double> to_earlier_tips;
  std::array<double, number_of_slots> diameters{};
  std::size_t number_of_diameters =
    0; // of the first slots, which were measured; those of the others are 0
};

// All records of a segment, in the order of selection.
using Tip_records = std::vector<Tip_record>;

// Section III.D.1 for one more tip. `distances` are those from the tip.
inline void add_tip_record(Indexed_surface::Index tip,
                           bool is_plausible,
                           const std::vector<double>& distances,
                           Tip_records& records)
{
  std::vector<double> to_earlier_tips;
  for (const Tip_record& record : records)
    to_earlier_tips.push_back(distances[record.tip]);
  records.push_back({tip, is_plausible, Distance_histogram(distances), std::move(to_earlier_tips)});
}

// Section III.D.2 for the first slots of a tip. `distances` are those from the tip.
inline void measure_diameters(const Indexed_surface& surface,
                              const std::vector<double>& distances,
                              std::size_t number,
                              Plane_section& section,
                              Execution& execution,
                              Tip_record& record)
{
  const Slots tip_slots(distances, record.histogram, number);
  record.diameters = sectional_diameter_histogram(surface, distances, tip_slots, section, execution);
  record.number_of_diameters = number;
}

// What a border must satisfy.
struct Border_conditions
{
  double minimum_prominence;
  bool uses_candidate_intervals;
  bool accepts_implausible_tips;
  double largest_share = 1; // of the faces that a protrusion may have

  // For given tips every protrusion is accepted that takes at most half of the segment.
  Border_conditions for_given_tips() const
  {
    return {minimum_prominence, uses_candidate_intervals, true, 0.5};
  }
};

// The distance from tip `i` to the nearest other tip in use.
inline double distance_to_nearest_tip(const Tip_records& records,
                                      std::size_t i,
                                      const Border_conditions& conditions)
{
  double nearest = (std::numeric_limits<double>::infinity)();
  for (std::size_t j = 0; j < records.size(); ++j)
    if (j != i && (records[j].is_plausible || conditions.accepts_implausible_tips))
      nearest = (std::min)(nearest,
                           j < i ? records[i].to_earlier_tips[j] : records[j].to_earlier_tips[i]);
  return nearest;
}

// Where the border of a tip may lie, whatever the diameters are. A border beyond another tip is none: the protrusion would
// swallow that tip.
class Border_range
{
public:
  Border_range(const Tip_records& records, std::size_t i, const Border_conditions& conditions)
    : m_histogram(records[i].histogram),
      m_largest_share(conditions.largest_share),
      m_uses_candidate_intervals(conditions.uses_candidate_intervals)
  {
    if (!records[i].is_plausible && !conditions.accepts_implausible_tips)
      return;
    m_end = distance_to_nearest_tip(records, i, conditions);
    if (m_uses_candidate_intervals)
      m_intervals = candidate_intervals(m_histogram);
  }

  bool contains(std::size_t slot) const
  {
    return m_histogram.slot_begin(slot) < m_end && m_histogram.share_before(slot) <= m_largest_share &&
           (!m_uses_candidate_intervals || internal::contains(m_intervals, slot));
  }

  // How many of the first slots must be measured to find the border.
  std::size_t slots_that_matter() const
  {
    for (std::size_t slot = number_of_slots; slot-- > Inflection_windows::first_slot;)
      if (contains(slot))
        return Inflection_windows::slots_for(slot);
    return 0;
  }

private:
  const Distance_histogram& m_histogram;
  double m_largest_share;
  bool m_uses_candidate_intervals;
  double m_end = -1; // no border
  std::vector<Slot_interval> m_intervals;
};

// Section III.D.3: the most prominent inflection of the diameters that lies in a candidate interval. The diameters of the
// slots that matter must have been measured.
inline std::optional<Inflection> border_of_tip(const Tip_records& records,
                                               std::size_t i,
                                               const Border_conditions& conditions)
{
  const Tip_record& record = records[i];
  const Border_range range(records, i, conditions);
  CGAL_assertion(range.slots_that_matter() <= record.number_of_diameters);
  for (const Inflection& inflection : inflection_points(record.diameters, record.number_of_diameters))
  {
    if (inflection.prominence < conditions.minimum_prominence)
      break;
    if (range.contains(inflection.slot))
      return inflection;
  }
  return std::nullopt;
}

// What is known of the protrusion of a tip before it is cut off.
inline Protrusion<Indexed_surface::Index> describe_protrusion(const Tip_record& record,
                                                              const Inflection& border)
{
  Protrusion<Indexed_surface::Index> protrusion;
  protrusion.border_slot = border.slot;
  protrusion.border_distance = record.histogram.slot_begin(border.slot);
  protrusion.value = border.prominence;
  protrusion.distance_histogram.assign(record.histogram.counts.begin(), record.histogram.counts.end());
  protrusion.sectional_diameter_histogram.assign(record.diameters.begin(), record.diameters.end());
  return protrusion;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_TIP_RECORD_H
