// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_HISTOGRAM_SEGMENTATION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_HISTOGRAM_SEGMENTATION_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Next_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/Segment_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/Tip_record.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/cut_off_protrusion.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The flow of Fig. 2: tips in the largest segment, a border for each, labels, until there are enough
// segments.
class Histogram_segmentation
{
public:
  using Index = Indexed_surface::Index;

  Histogram_segmentation(const Indexed_surface& surface,
                         const Any_distance& distance,
                         const Border_conditions& conditions,
                         Execution& execution)
    : m_surface(surface),
      m_distance(distance),
      m_conditions(conditions),
      m_execution(execution),
      m_observer(execution.observer()),
      m_select(surface, execution.is_parallel()),
      m_segments(surface)
  {
    for (std::size_t s = 0; s < m_segments.number_of_segments(); ++s)
      m_areas.push_back(m_segments.area(surface, s));
    m_records.resize(m_areas.size());
  }

  // If no segment has a border prominent enough while there are fewer than k, the conditions are relaxed:
  // implausible tips are accepted and the least prominence is halved, again and again.
  Nested_segments with_number_of_segments(std::size_t k)
  {
    split_all(k);
    m_conditions.accepts_implausible_tips = true;
    for (; m_conditions.minimum_prominence > least_prominence; m_conditions.minimum_prominence /= 2)
      split_all(k);
    return std::move(m_segments);
  }

  // Stops when no segment has a border prominent enough. Small segments are not split: details have prominent borders as well.
  Nested_segments with_automatic_number()
  {
    // between .1 and .2 the Rand index error is the same, and the number of segments falls from 16 to 11
    constexpr double least_share_of_area = 0.2;
    m_least_area_to_split = least_share_of_area * m_surface.area();
    split_all(std::nullopt);
    return std::move(m_segments);
  }

  // Cuts off the protrusions of the given tips.
  Nested_segments from_tips(const std::vector<Index>& tips)
  {
    std::vector<std::vector<Index>> tips_of_segment(m_segments.number_of_segments());
    for (Index tip : distinct_tips(m_surface, tips))
      tips_of_segment[m_segments.labels()[tip]].push_back(tip);
    for (Index s = 0; s < tips_of_segment.size(); ++s)
    {
      if (tips_of_segment[s].empty())
        continue;
      const Next_segment progress(m_execution, s, tips_of_segment.size());
      Segment_surface segment = make_segment(s);
      record_given_tips(segment, tips_of_segment[s]);
      Tip_records& records = m_records[s];
      const std::size_t number_of_tips = tips_of_segment[s].size();
      const auto measure = [&](std::size_t tip, std::size_t number)
      { segment.measure_first_slots(tip, number, m_execution, records[tip]); };
      cut_off_all(segment, find_borders(records, number_of_tips, number_of_tips, m_conditions.for_given_tips(), true, measure));
      m_observer.distances_computed(segment.distances->number_of_runs());
    }
    return std::move(m_segments);
  }

private:
  // a diameter that grows by 1 % over 5 slots does not grow
  static constexpr double least_prominence = 0.01;

  // A tip of a segment by its number, and its border.
  using Tip_border = std::pair<std::size_t, Inflection>;

  void split_all(std::optional<std::size_t> k)
  {
    // The borders of more tips in one go, each nearer than the next tip, would lie too near to find any; on
    // the Princeton benchmark with 100 segments asked for, 37 were found without the limit and 99 with it.
    constexpr std::size_t maximum_number_of_tips = 12;
    std::vector<bool> is_exhausted(m_segments.number_of_segments(), false);
    while (!k || m_segments.number_of_segments() < *k)
    {
      const Next_segment progress(m_execution, m_segments.number_of_segments(), k);
      const std::optional<Index> largest = largest_segment(is_exhausted);
      if (!largest)
        return;
      const std::size_t missing = k ? *k - m_segments.number_of_segments() : maximum_number_of_tips;
      is_exhausted[*largest] = !split(*largest, (std::min)(missing, maximum_number_of_tips));
      is_exhausted.resize(m_segments.number_of_segments(), false);
    }
  }

  std::optional<Index> largest_segment(const std::vector<bool>& is_exhausted) const
  {
    std::optional<Index> largest;
    for (Index s = 0; s < m_areas.size(); ++s)
      if (!is_exhausted[s] && m_areas[s] >= m_least_area_to_split &&
          (!largest || m_areas[s] > m_areas[*largest]))
        largest = s;
    return largest;
  }

  Segment_surface make_segment(Index id)
  {
    const Stage_scope stage(m_observer, Stage::PREPARATION);
    const Nested_segments::Faces& faces = m_segments.faces(id);
    const bool is_whole = faces.size() == m_surface.number_of_faces();
    return Segment_surface(id, faces, is_whole ? Indexed_surface() : m_select(faces).to_surface(m_execution.is_parallel()),
                           m_surface, m_distance, m_execution);
  }

  // Steps 2 to 4 in one segment; returns whether a protrusion was cut off. The records of a segment that
  // has none stay, so that relaxed conditions cost no further distances.
  bool split(Index id, std::size_t wanted)
  {
    std::unique_ptr<Segment_surface> segment;
    const auto need_segment = [&]()
    {
      if (!segment)
        segment.reset(new Segment_surface(make_segment(id)));
      return segment.get();
    };
    if (m_records[id].empty())
      select_tips(*need_segment(), wanted);
    const auto measure = [&](std::size_t tip, std::size_t number)
    { need_segment()->measure_first_slots(tip, number, m_execution, m_records[id][tip]); };
    const std::vector<Tip_border> borders = find_borders(m_records[id], m_records[id].size(), wanted,
                                                         m_conditions, false, measure);
    if (!borders.empty())
      cut_off_all(*need_segment(), borders);
    if (segment)
      m_observer.distances_computed(segment->distances->number_of_runs());
    return !borders.empty();
  }

  void select_tips(Segment_surface& segment, std::size_t wanted)
  {
    const Stage_scope stage(m_observer, Stage::TIPS);
    select_protrusion_tips(
      segment.surface, *segment.distances, wanted, [&](Index face) { return is_plausible(segment, face); },
      [&](Index face, const std::vector<double>& distances)
      {
        if (is_plausible(segment, face))
          m_observer.tip_selected(segment.faces[face]);
        else
          m_observer.tip_eliminated(segment.faces[face]);
        add_record(segment, face, distances, m_conditions);
      });
  }

  // Where the segment was cut off there is no tip of a protrusion, however far. To be asked before it is cut again.
  bool is_plausible(const Segment_surface& segment, Index face) const
  {
    return !m_segments.is_on_border(m_surface, segment.faces[face]);
  }

  // The border is looked for when all tips are known: the diameters beyond the nearest one do not matter. If the distances
  // cannot be kept until then, what may matter is measured at once, by the tips that are known.
  void add_record(Segment_surface& segment,
                  Index face,
                  const std::vector<double>& distances,
                  const Border_conditions& conditions)
  {
    m_execution.check();
    Tip_records& records = m_records[segment.id];
    add_tip_record(face, is_plausible(segment, face), distances, records);
    if (segment.keep(distances))
      return;
    const Stage_scope stage(m_observer, Stage::BORDERS);
    const std::size_t number = Border_range(records, records.size() - 1, conditions).slots_that_matter();
    segment.measure(distances, number, m_execution, records.back());
  }

  // The records of given tips, faces of the whole surface, and of further ones if they are few.
  void record_given_tips(Segment_surface& segment, const std::vector<Index>& tips)
  {
    const Stage_scope stage(m_observer, Stage::TIPS);
    std::vector<double> to_nearest_tip(segment.surface.number_of_faces(), (std::numeric_limits<double>::max)());
    std::vector<double> distances;
    for (std::size_t i = 0; i < (std::max)(tips.size(), least_number_of_tips); ++i)
    {
      const auto farthest = std::max_element(to_nearest_tip.begin(), to_nearest_tip.end());
      if (i >= tips.size() && *farthest <= 0)
        break;
      const Index face = i < tips.size() ? segment.number_of_face(tips[i])
                                         : static_cast<Index>(farthest - to_nearest_tip.begin());
      (*segment.distances)(face, distances);
      add_record(segment, face, distances, m_conditions.for_given_tips());
      for (std::size_t f = 0; f < distances.size(); ++f)
        to_nearest_tip[f] = (std::min)(to_nearest_tip[f], distances[f]);
    }
  }

  // Step 3: the first tips that have a border, at most `wanted` of `number_of_tips`. `measure(tip, number of slots)` sees to it
  // that the diameters of these slots are known. If `relaxes`, the conditions are relaxed for each tip until it has a border.
  template <typename Measure>
  std::vector<Tip_border> find_borders(const Tip_records& records,
                                       std::size_t number_of_tips,
                                       std::size_t wanted,
                                       const Border_conditions& conditions,
                                       bool relaxes,
                                       Measure measure)
  {
    const Stage_scope stage(m_observer, Stage::BORDERS);
    std::vector<Tip_border> borders;
    for (std::size_t i = 0; i < number_of_tips && borders.size() < wanted; ++i)
    {
      measure(i, Border_range(records, i, conditions).slots_that_matter());
      Border_conditions relaxed = conditions;
      std::optional<Inflection> border = border_of_tip(records, i, relaxed);
      while (relaxes && !border && (relaxed.minimum_prominence /= 2) > least_prominence)
        border = border_of_tip(records, i, relaxed);
      if (border)
        borders.push_back({i, *border});
    }
    return borders;
  }

  // Step 4. Skips tips that lie in the protrusion of another one, or whose protrusion would take all that remains. The tips
  // of what remains are selected anew when it is its turn.
  void cut_off_all(Segment_surface& segment, const std::vector<Tip_border>& borders)
  {
    const Stage_scope stage(m_observer, Stage::LABELS);
    const Indexed_surface& surface = segment.surface;
    Tip_records records = std::exchange(m_records[segment.id], {});
    std::vector<Index> labels(surface.number_of_faces(), segment.id);
    for (const Tip_border& tip_border : borders)
    {
      const Tip_record& record = records[tip_border.first];
      if (labels[record.tip] != segment.id)
        continue;
      const double border_distance = record.histogram.slot_begin(tip_border.second.slot);
      const std::vector<double>& distances = segment.from(tip_border.first, record.tip, border_distance);
      const auto is_near = [&](Index f) { return distances[f] < border_distance; };
      if (!leaves_a_face(labels, segment.id, is_near))
        continue;
      const Index id = static_cast<Index>(m_segments.number_of_segments());
      const double area = cut_off_protrusion(surface, labels, record.tip, is_near, id);
      if (m_observer.looks_at_protrusions())
        segment.measure_first_slots(tip_border.first, number_of_slots, m_execution,
                                    records[tip_border.first]);
      m_segments.cut_off(segment.id, faces_with_label(labels, id, segment.faces));
      Protrusion<Index> protrusion = describe_protrusion(record, tip_border.second);
      protrusion.segment = id;
      protrusion.parent = segment.id;
      protrusion.tip = segment.faces[record.tip];
      protrusion.area = area;
      protrusion.border_length = border_length(surface, labels, id);
      m_observer.protrusion_found(protrusion);
      m_areas.push_back(m_segments.area(m_surface, id));
    }
    m_areas[segment.id] = m_segments.area(m_surface, segment.id);
    m_records.resize(m_segments.number_of_segments());
  }

  const Indexed_surface& m_surface;
  const Any_distance& m_distance;
  Border_conditions m_conditions;
  Execution& m_execution;
  Observer& m_observer;
  Face_selector<Indexed_surface> m_select;
  Nested_segments m_segments;
  std::vector<double> m_areas; // of every segment
  double m_least_area_to_split = 0;
  std::vector<Tip_records> m_records; // of every segment whose tips were selected
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_HISTOGRAM_SEGMENTATION_H
