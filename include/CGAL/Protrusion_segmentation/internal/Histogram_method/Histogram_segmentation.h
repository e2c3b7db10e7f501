// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_HISTOGRAM_SEGMENTATION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_HISTOGRAM_SEGMENTATION_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Monitor.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/Tip_record.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

template <typename Distances, typename = void>
struct Has_bounded_distances : std::false_type {};

template <typename Distances>
struct Has_bounded_distances<Distances,
                             std::void_t<decltype(std::declval<Distances&>()(
                               Indexed_surface::Index(), std::declval<std::vector<double>&>(), 0.))>>
  : std::true_type {};

// The distances of the faces up to `bound`; the others, if they are not computed, are larger.
template <typename Distances>
void distances_up_to(double bound,
                     Indexed_surface::Index source,
                     Distances& distances,
                     std::vector<double>& result)
{
  if constexpr (Has_bounded_distances<Distances>::value)
    distances(source, result, bound);
  else
    distances(source, result);
}

// The flow of Fig. 2: tips in the largest segment, a border for each, labels, until there are enough
// segments.
template <typename Distance, typename Visitor>
class Histogram_segmentation
{
public:
  using Index = Indexed_surface::Index;

  Histogram_segmentation(const Indexed_surface& surface,
                         const Distance& distance,
                         const Border_conditions& conditions,
                         bool parallel,
                         Monitor<Visitor>& monitor)
    : m_surface(surface),
      m_distance(distance),
      m_conditions(conditions),
      m_parallel(parallel),
      m_monitor(monitor),
      m_extract(surface),
      m_forest(surface),
      m_records(m_forest.number_of_segments())
  {}

  // If no segment has a border prominent enough while there are fewer than k, the conditions are relaxed:
  // implausible tips are accepted and the least prominence is halved, again and again.
  Nested_segments with_number_of_segments(std::size_t k)
  {
    constexpr double least_prominence = 0.01; // a diameter that grows by 1 % over 5 slots does not grow
    split_all(k);
    m_conditions.accepts_implausible_tips = true;
    for (; m_conditions.minimum_prominence > least_prominence; m_conditions.minimum_prominence /= 2)
      split_all(k);
    return std::move(m_forest);
  }

  // Stops when no segment has an evident protrusion. Small segments are not looked into: the flow takes the
  // largest one first, and details have prominent borders as well.
  Nested_segments with_evident_protrusions()
  {
    // between .1 and .2 the Rand index error is the same, and the number of segments falls from 16 to 11
    constexpr double least_share_of_area = 0.2;
    m_least_area_to_split = least_share_of_area * m_surface.area();
    split_all(Monitor<Visitor>::unlimited());
    return std::move(m_forest);
  }

  // Cuts off the protrusions of the given tips.
  Nested_segments from_tips(const std::vector<Index>& tips)
  {
    std::vector<std::vector<Index>> tips_of_segment(m_forest.number_of_segments());
    for (Index tip : tips)
    {
      // a tip given twice must not be its own nearest other tip
      std::vector<Index>& others = tips_of_segment[m_forest.labels[tip]];
      if (std::find(others.begin(), others.end(), tip) == others.end())
        others.push_back(tip);
    }
    for (Index s = 0; s < tips_of_segment.size(); ++s)
      if (!tips_of_segment[s].empty())
      {
        Segment segment(*this, s);
        record_given_tips(segment, tips_of_segment[s]);
        cut_off_all(segment, find_borders(s, tips.size()));
        m_monitor.visitor().distances_computed(segment.distances.number_of_runs());
      }
    return std::move(m_forest);
  }

private:
  // A tip of a segment by its number, and its border.
  using Tip_border = std::pair<std::size_t, Inflection>;

  // A segment as a surface of its own with the distances on it.
  struct Segment
  {
    Index id;
    Extracted_segment extracted;
    decltype(std::declval<const Distance&>().on(std::declval<const Indexed_surface&>(), 0u)) distances;

    Segment(Histogram_segmentation& segmentation, Index id_)
      : id(id_),
        extracted(segmentation.m_extract(segmentation.m_forest.faces_of(id_))),
        distances(segmentation.m_distance.on(extracted.part, segmentation.m_monitor.random_seed()))
    {}
    Segment(const Segment&) = delete;
    Segment& operator=(const Segment&) = delete;
  };

  void split_all(std::size_t k)
  {
    // The borders of more tips in one go, each nearer than the next tip, would lie too near to find any; on
    // the Princeton benchmark with 100 segments asked for, 37 were found without the limit and 99 with it.
    constexpr std::size_t maximum_number_of_tips = 12;
    std::vector<bool> is_exhausted(m_forest.number_of_segments(), false);
    while (m_forest.number_of_segments() < k)
    {
      m_monitor.progress(m_forest.number_of_segments(), k);
      const std::optional<Index> largest = largest_segment(is_exhausted);
      if (!largest)
        return;
      const std::size_t missing = k - m_forest.number_of_segments();
      is_exhausted[*largest] = !split(*largest, (std::min)(missing, maximum_number_of_tips));
      is_exhausted.resize(m_forest.number_of_segments(), false);
    }
  }

  std::optional<Index> largest_segment(const std::vector<bool>& is_exhausted) const
  {
    std::vector<double> areas(m_forest.number_of_segments(), 0);
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      areas[m_forest.labels[f]] += m_surface.area(f);
    std::optional<Index> largest;
    for (Index s = 0; s < areas.size(); ++s)
      if (!is_exhausted[s] && areas[s] >= m_least_area_to_split &&
          (!largest || areas[s] > areas[*largest]))
        largest = s;
    return largest;
  }

  // Steps 2 to 4 in one segment; returns whether a protrusion was cut off. The records of a segment that
  // has none stay, so that relaxed conditions cost no further distances.
  bool split(Index id, std::size_t wanted)
  {
    std::optional<Segment> segment;
    if (m_records[id].empty())
    {
      segment.emplace(*this, id);
      select_tips(*segment, wanted);
    }
    const std::vector<Tip_border> borders = find_borders(id, wanted);
    if (!borders.empty())
    {
      if (!segment)
        segment.emplace(*this, id);
      cut_off_all(*segment, borders);
    }
    if (segment)
      m_monitor.visitor().distances_computed(segment->distances.number_of_runs());
    return !borders.empty();
  }

  void select_tips(Segment& segment, std::size_t wanted)
  {
    const Stage_scope<Visitor> stage(m_monitor.visitor(), Stage::TIPS);
    const Extracted_segment& extracted = segment.extracted;
    Plane_section section(extracted.part);
    select_protrusion_tips(
      extracted.part, segment.distances, wanted,
      // where the segment was cut off there is no tip of a protrusion, however far it may be
      [&](Index face) { return !extracted.is_on_cut[face]; },
      [&](Index face, const std::vector<double>& distances)
      {
        m_monitor.check();
        if (extracted.is_on_cut[face])
          m_monitor.visitor().tip_eliminated(m_monitor.position(extracted.faces[face]));
        else
          m_monitor.visitor().tip_found(m_monitor.position(extracted.faces[face]));
        add_tip_record(extracted.part, face, !extracted.is_on_cut[face], distances, section,
                       m_records[segment.id], m_parallel);
      });
  }

  // The records of tips that were not selected here; `tips` are faces of the whole surface.
  void record_given_tips(Segment& segment, const std::vector<Index>& tips)
  {
    Plane_section section(segment.extracted.part);
    std::vector<double> distances;
    for (Index tip : tips)
    {
      const std::vector<Index>& faces = segment.extracted.faces;
      const Index face =
        static_cast<Index>(std::lower_bound(faces.begin(), faces.end(), tip) - faces.begin());
      segment.distances(face, distances);
      add_tip_record(segment.extracted.part, face, true, distances, section, m_records[segment.id],
                     m_parallel);
    }
  }

  // Step 3: the tips that have a border, at most `wanted`.
  std::vector<Tip_border> find_borders(Index id, std::size_t wanted)
  {
    const Stage_scope<Visitor> stage(m_monitor.visitor(), Stage::BORDERS);
    std::vector<Tip_border> borders;
    for (std::size_t i = 0; i < m_records[id].size() && borders.size() < wanted; ++i)
      if (const std::optional<Inflection> border = border_of_tip(m_records[id], i, m_conditions))
        borders.push_back({i, *border});
    return borders;
  }

  // Step 4. A tip that lies in the protrusion of another one, or whose protrusion would be all that is left,
  // is left out. The tips of what remains are selected anew when it is its turn.
  void cut_off_all(Segment& segment, const std::vector<Tip_border>& borders)
  {
    const Stage_scope<Visitor> stage(m_monitor.visitor(), Stage::LABELS);
    const Tip_records records = std::exchange(m_records[segment.id], {});
    std::vector<Index> labels(segment.extracted.part.number_of_faces(), segment.id);
    std::vector<double> distances;
    for (const Tip_border& tip_border : borders)
    {
      const Tip_record& record = records[tip_border.first];
      if (labels[record.tip] != segment.id)
        continue;
      m_monitor.check();
      const double border_distance = record.histogram.slot_begin(tip_border.second.slot);
      distances_up_to(border_distance, record.tip, segment.distances, distances);
      const auto is_near = [&](Index f) { return distances[f] < border_distance; };
      if (!leaves_a_face(labels, segment.id, is_near))
        continue;
      const Index id = m_forest.add_segment(segment.id);
      const double area = cut_off_protrusion(segment.extracted.part, labels, record.tip, is_near, id);
      report(segment, record, tip_border.second, id, area,
             border_length(segment.extracted.part, labels, id));
    }
    m_records.resize(m_forest.number_of_segments());
    for (Index f = 0; f < labels.size(); ++f)
      m_forest.labels[segment.extracted.faces[f]] = labels[f];
  }

  // Whether a face of the segment is not near: the border may lie beyond all that earlier protrusions left.
  template <typename IsNear>
  static bool leaves_a_face(const std::vector<Index>& labels, Index id, IsNear is_near)
  {
    for (Index f = 0; f < labels.size(); ++f)
      if (labels[f] == id && !is_near(f))
        return true;
    return false;
  }

  void report(const Segment& segment,
              const Tip_record& record,
              const Inflection& border,
              Index id,
              double area,
              double length)
  {
    const double unit = m_monitor.unit();
    Protrusion protrusion;
    protrusion.segment = id;
    protrusion.parent = segment.id;
    protrusion.tip = m_monitor.position(segment.extracted.faces[record.tip]);
    protrusion.border_slot = border.slot;
    protrusion.border_distance = record.histogram.slot_begin(border.slot) * unit;
    protrusion.score = border.prominence;
    protrusion.area = area * unit * unit;
    protrusion.border_length = length * unit;
    protrusion.distance_histogram.assign(record.histogram.counts.begin(), record.histogram.counts.end());
    for (double diameter : record.diameters)
      protrusion.sectional_diameter_histogram.push_back(diameter * unit);
    m_monitor.visitor().protrusion_found(protrusion);
  }

  const Indexed_surface& m_surface;
  const Distance& m_distance;
  Border_conditions m_conditions;
  bool m_parallel;
  Monitor<Visitor>& m_monitor;
  Segment_extractor m_extract;
  Nested_segments m_forest;
  double m_least_area_to_split = 0;
  std::vector<Tip_records> m_records; // of every segment whose tips were selected
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_HISTOGRAM_SEGMENTATION_H
