// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_TIP_RECORD_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_TIP_RECORD_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/detect_border.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/distance_histogram.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/plane_section.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/sectional_diameter_histogram.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// What is kept of the distances from a tip: enough to decide on its border at any later time.
struct Tip_record
{
  Indexed_surface::Index tip; // face of the segment
  bool is_plausible;       // else to be used only when no plausible tip has a border
  Distance_histogram histogram;
  std::array<double, number_of_slots> diameters;
  std::vector<double> to_earlier_tips;
};

// All records of a segment, in the order of selection.
using Tip_records = std::vector<Tip_record>;

// Section III.D.1 and III.D.2 for one more tip. `distances` are those from the tip.
inline void add_tip_record(const Indexed_surface& surface,
                           Indexed_surface::Index tip,
                           bool is_plausible,
                           const std::vector<double>& distances,
                           Plane_section& section,
                           Execution& execution,
                           Tip_records& records)
{
  const Slots slots(distances);
  std::vector<double> to_earlier_tips;
  for (const Tip_record& record : records)
    to_earlier_tips.push_back(distances[record.tip]);
  records.push_back({tip, is_plausible, slots.histogram(),
                     sectional_diameter_histogram(surface, distances, slots, section, execution),
                     std::move(to_earlier_tips)});
}

// What a border must satisfy.
struct Border_conditions
{
  double minimum_prominence;
  bool uses_candidate_intervals;
  bool accepts_implausible_tips;
  double largest_share = 1; // of the faces that a protrusion may have
};

// The distance from tip `i` to the nearest other tip in use.
inline double distance_to_nearest_tip(const Tip_records& records,
                                      std::size_t i,
                                      const Border_conditions& conditions)
{
  double nearest = (std::numeric_limits<double>::infinity)();
  for (std::size_t j = 0; j < records.size(); ++j)
    if (j != i && (records[j].is_plausible || conditions.accepts_implausible_tips))
      nearest = (std::min)(nearest, j < i ? records[i].to_earlier_tips[j] : records[j].to_earlier_tips[i]);
  return nearest;
}

// Section III.D.3: the most prominent inflection of the diameters that lies in a candidate interval. A
// border beyond another tip is none: the protrusion would swallow that tip.
inline std::optional<Inflection> border_of_tip(const Tip_records& records,
                                               std::size_t i,
                                               const Border_conditions& conditions)
{
  const Tip_record& record = records[i];
  if (!record.is_plausible && !conditions.accepts_implausible_tips)
    return std::nullopt;
  const double to_nearest_tip = distance_to_nearest_tip(records, i, conditions);
  const std::vector<Slot_interval> intervals = candidate_intervals(record.histogram);
  for (const Inflection& inflection : inflection_points(record.diameters))
  {
    if (inflection.prominence < conditions.minimum_prominence)
      break;
    if (record.histogram.share_before(inflection.slot) > conditions.largest_share)
      continue;
    if ((!conditions.uses_candidate_intervals || contains(intervals, inflection.slot)) &&
        record.histogram.slot_begin(inflection.slot) < to_nearest_tip)
      return inflection;
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_TIP_RECORD_H
