// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_SEGMENTATION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_SEGMENTATION_H

#include <CGAL/Protrusion_segmentation/Surface_part.h>
#include <CGAL/Protrusion_segmentation/internal/Monitor.h>
#include <CGAL/Protrusion_segmentation/internal/Segment_forest.h>
#include <CGAL/Protrusion_segmentation/internal/detect_border.h>
#include <CGAL/Protrusion_segmentation/internal/extract_part.h>
#include <CGAL/Protrusion_segmentation/internal/label_segments.h>
#include <CGAL/Protrusion_segmentation/internal/sectional_diameter_histogram.h>
#include <CGAL/Protrusion_segmentation/internal/select_protrusion_tips.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// What is computed for a tip while the distances from it are at hand.
struct Tip_record
{
  Surface_part::Index tip;
  Distance_histogram histogram;
  std::array<double, number_of_slots> diameters;
  double to_nearest_tip = (std::numeric_limits<double>::infinity)();
};

// The flow of Fig. 2: tips in the largest segment, a border for each, labels, until there are enough
// segments.
template <typename Distance, typename Options, typename Visitor>
class Histogram_segmentation
{
public:
  using Index = Surface_part::Index;

  Histogram_segmentation(const Surface_part& surface,
                         const Distance& distance,
                         const Options& options,
                         Monitor<Visitor>& monitor)
    : m_surface(surface),
      m_distance(distance),
      m_options(options),
      m_monitor(monitor),
      m_extract(surface),
      m_forest(surface),
      m_minimum_prominence(options.minimum_prominence())
  {}

  // Segments with k as the paper has it. If no segment has a border prominent enough while there are fewer
  // than k, the least prominence is halved and all are tried again.
  Segment_forest with_number_of_segments(std::size_t k)
  {
    for (; m_minimum_prominence >= m_options.least_prominence(); m_minimum_prominence /= 2)
      split_all(k);
    return std::move(m_forest);
  }

  // Stops when no segment has an evident protrusion.
  Segment_forest with_evident_protrusions()
  {
    split_all((std::numeric_limits<std::size_t>::max)());
    return std::move(m_forest);
  }

  // Cuts off the protrusions of the given tips.
  Segment_forest from_tips(const std::vector<Index>& tips)
  {
    std::vector<std::vector<Index>> tips_of_segment(m_forest.number_of_segments());
    for (Index tip : tips)
      tips_of_segment[m_forest.labels[tip]].push_back(tip);
    for (Index s = 0; s < tips_of_segment.size(); ++s)
      if (!tips_of_segment[s].empty())
        split(s, tips.size(), tips_of_segment[s]);
    return std::move(m_forest);
  }

private:
  void split_all(std::size_t k)
  {
    std::vector<bool> is_exhausted(m_forest.number_of_segments(), false);
    while (m_forest.number_of_segments() < k)
    {
      m_monitor.progress(m_forest.number_of_segments(), k);
      const std::optional<Index> largest = largest_segment(is_exhausted);
      if (!largest)
        return;
      const std::size_t wanted =
        (std::min)(k - m_forest.number_of_segments(), m_options.maximum_number_of_tips());
      is_exhausted[*largest] = (split(*largest, wanted, {}) == 0);
      is_exhausted.resize(m_forest.number_of_segments(), false);
    }
  }

  bool is_relaxed() const { return m_minimum_prominence < m_options.minimum_prominence(); }

  std::optional<Index> largest_segment(const std::vector<bool>& is_exhausted) const
  {
    std::vector<double> areas(m_forest.number_of_segments(), 0);
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      areas[m_forest.labels[f]] += m_surface.area(f);
    std::optional<Index> largest;
    for (Index s = 0; s < areas.size(); ++s)
      if (!is_exhausted[s] && (!largest || areas[s] > areas[*largest]))
        largest = s;
    return largest;
  }

  // Steps 2 to 4 in one segment; `tips`, faces of the surface, are selected if there are none. Returns how
  // many protrusions were cut off.
  std::size_t split(Index segment, std::size_t wanted, const std::vector<Index>& tips)
  {
    const Extracted_part segment_part = m_extract(m_forest.faces_of(segment));
    const Surface_part& part = segment_part.part;
    auto distances = m_distance.on(part, m_monitor.random_seed());
    std::vector<Tip_record> records = tips.empty()
                                        ? select_tips(segment_part, distances, wanted)
                                        : given_tips(segment_part, distances, tips);
    const Stage_scope<Visitor> stage(m_monitor.visitor(), Stage::BORDERS);
    std::vector<Index> labels(part.number_of_faces(), segment);
    std::size_t found = 0;
    for (const Tip_record& record : records)
    {
      m_monitor.check();
      const std::optional<Inflection> border = border_of(record);
      if (border && labels[record.tip] == segment && found < wanted)
      {
        cut_off(segment_part, distances, record, *border, labels);
        ++found;
      }
    }
    m_monitor.visitor().distances_computed(distances.number_of_runs());
    for (Index f = 0; f < labels.size(); ++f)
      m_forest.labels[segment_part.faces[f]] = labels[f];
    return found;
  }

  static Tip_record record_tip(const Surface_part& part,
                               Index tip,
                               const std::vector<double>& from_tip,
                               Plane_section& section)
  {
    Distance_histogram histogram(from_tip);
    const auto diameters = sectional_diameter_histogram(part, from_tip, histogram, section);
    return {tip, std::move(histogram), diameters};
  }

  // Keeps for both tips of every pair the distance to the nearest other one.
  static void relate_tips(std::vector<Tip_record>& records, const std::vector<double>& from_last)
  {
    Tip_record& last = records.back();
    for (std::size_t i = 0; i + 1 < records.size(); ++i)
    {
      const double distance = from_last[records[i].tip];
      records[i].to_nearest_tip = (std::min)(records[i].to_nearest_tip, distance);
      last.to_nearest_tip = (std::min)(last.to_nearest_tip, distance);
    }
  }

  template <typename Distances>
  std::vector<Tip_record> select_tips(const Extracted_part& segment_part,
                                      Distances& distances,
                                      std::size_t wanted)
  {
    const Stage_scope<Visitor> stage(m_monitor.visitor(), Stage::TIPS);
    Plane_section section(segment_part.part);
    std::vector<Tip_record> records;
    select_protrusion_tips(
      segment_part.part, distances, wanted,
      [&](Index face)
      {
        const bool is_plausible = is_relaxed() || !segment_part.is_on_cut[face];
        if (!is_plausible)
          m_monitor.visitor().tip_eliminated(segment_part.faces[face]);
        return is_plausible;
      },
      [&](Index tip, const std::vector<double>& from_tip)
      {
        m_monitor.check();
        m_monitor.visitor().tip_found(segment_part.faces[tip]);
        records.push_back(record_tip(segment_part.part, tip, from_tip, section));
        relate_tips(records, from_tip);
      });
    return records;
  }

  // The records of tips that were not selected here; `tips` are faces of the whole surface.
  template <typename Distances>
  std::vector<Tip_record> given_tips(const Extracted_part& segment_part,
                                     Distances& distances,
                                     const std::vector<Index>& tips)
  {
    Plane_section section(segment_part.part);
    std::vector<Tip_record> records;
    std::vector<double> from_tip;
    for (Index tip : tips)
    {
      const auto position = std::lower_bound(segment_part.faces.begin(), segment_part.faces.end(), tip);
      const Index local = static_cast<Index>(position - segment_part.faces.begin());
      distances(local, from_tip);
      records.push_back(record_tip(segment_part.part, local, from_tip, section));
      relate_tips(records, from_tip);
    }
    return records;
  }

  // Section III.D.3: the most prominent inflection of the diameters in a candidate interval. The border
  // must not lie beyond another tip: then the protrusion would swallow it.
  std::optional<Inflection> border_of(const Tip_record& record) const
  {
    const std::vector<Slot_interval> intervals =
      candidate_intervals(record.histogram, m_options.interval_margin());
    for (const Inflection& inflection :
         inflection_points(record.diameters, m_options.inflection_width(), m_options.first_slot()))
    {
      if (inflection.prominence < m_minimum_prominence)
        break;
      const bool is_candidate =
        !m_options.uses_candidate_intervals() || contains(intervals, inflection.slot);
      if (is_candidate && record.histogram.slot_begin(inflection.slot) < record.to_nearest_tip)
        return inflection;
    }
    return std::nullopt;
  }

  template <typename Distances>
  void cut_off(const Extracted_part& segment_part,
               Distances& distances,
               const Tip_record& record,
               const Inflection& border,
               std::vector<Index>& labels)
  {
    const double border_distance = record.histogram.slot_begin(border.slot);
    std::vector<double> from_tip;
    distances(record.tip, from_tip);
    const Index parent = labels[record.tip];
    const Index id = m_forest.add_segment(parent);
    const double area = cut_off_protrusion(
      segment_part.part, labels, record.tip,
      [&](Index f) { return from_tip[f] < border_distance; }, id);
    report(segment_part, record, border, {id, parent}, area, labels);
  }

  void report(const Extracted_part& segment_part,
              const Tip_record& record,
              const Inflection& border,
              std::pair<Index, Index> id_and_parent,
              double area,
              const std::vector<Index>& labels)
  {
    Protrusion protrusion;
    protrusion.segment = id_and_parent.first;
    protrusion.parent = id_and_parent.second;
    protrusion.tip = segment_part.faces[record.tip];
    protrusion.border_slot = border.slot;
    protrusion.border_distance = record.histogram.slot_begin(border.slot) * m_monitor.unit();
    protrusion.score = border.prominence;
    protrusion.area = area * m_monitor.unit() * m_monitor.unit();
    protrusion.border_length =
      border_length(segment_part.part, labels, id_and_parent.first) * m_monitor.unit();
    for (std::size_t s = 0; s < number_of_slots; ++s)
    {
      protrusion.distance_histogram.push_back(record.histogram.count(s));
      protrusion.sectional_diameter_histogram.push_back(record.diameters[s] * m_monitor.unit());
    }
    m_monitor.visitor().protrusion_found(protrusion);
  }

  const Surface_part& m_surface;
  const Distance& m_distance;
  const Options& m_options;
  Monitor<Visitor>& m_monitor;
  Part_extractor m_extract;
  Segment_forest m_forest;
  double m_minimum_prominence;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_SEGMENTATION_H
