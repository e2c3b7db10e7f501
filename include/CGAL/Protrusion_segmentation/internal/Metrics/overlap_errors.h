// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formulas of the metrics that depend on the overlaps of the segments only.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_OVERLAP_ERRORS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_OVERLAP_ERRORS_H

#include <CGAL/Protrusion_segmentation/Consistency_error.h>
#include <CGAL/Protrusion_segmentation/Hamming_distance.h>

#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Segment numbers 0..n-1 in the order of `faces(mesh)`; ids are numbered as they first appear, so
// that ids with gaps, negative or huge ones are as good as any.
template <typename FaceGraph, typename SegmentIdMap>
std::vector<std::size_t> compact_segment_ids(const FaceGraph& mesh, const SegmentIdMap& segment_ids)
{
  using Id = typename boost::property_traits<SegmentIdMap>::value_type;

  std::unordered_map<Id, std::size_t> number_of_id;
  std::vector<std::size_t> numbers;
  numbers.reserve(num_faces(mesh));
  for (const auto f : faces(mesh))
    numbers.push_back(number_of_id.emplace(get(segment_ids, f), number_of_id.size()).first->second);
  return numbers;
}

// What a set of faces weighs.
struct Count_and_area
{
  std::uint64_t count = 0; // number of faces
  double area = 0;

  void add(double face_area)
  {
    ++count;
    area += face_area;
  }
};

class Segment_overlap
{
public:
  // The faces common to a segment of the first and one of the second segmentation; never empty.
  struct Cell
  {
    std::size_t first;
    std::size_t second;
    Count_and_area common;
  };

  // All three ranges are in one order of the faces; segment numbers are below the number of faces.
  // Linear in the number of faces, whatever the numbers of segments.
  Segment_overlap(const std::vector<std::size_t>& first_numbers,
                  const std::vector<std::size_t>& second_numbers,
                  const std::vector<double>& face_areas)
  {
    CGAL_precondition(first_numbers.size() == face_areas.size());
    CGAL_precondition(second_numbers.size() == face_areas.size());
    for (std::size_t i = 0; i < face_areas.size(); ++i)
    {
      m_total.add(face_areas[i]);
      add_to(m_first, first_numbers[i], face_areas[i]);
      add_to(m_second, second_numbers[i], face_areas[i]);
      cell(first_numbers[i], second_numbers[i], face_areas.size()).common.add(face_areas[i]);
    }
  }

  const Count_and_area& total() const { return m_total; }
  const std::vector<Count_and_area>& first_segments() const { return m_first; }
  const std::vector<Count_and_area>& second_segments() const { return m_second; }
  // in the order of first appearance, which makes sums over them deterministic
  const std::vector<Cell>& cells() const { return m_cells; }

private:
  static void add_to(std::vector<Count_and_area>& segments, std::size_t number, double face_area)
  {
    if (number >= segments.size())
      segments.resize(number + 1);
    segments[number].add(face_area);
  }

  Cell& cell(std::size_t first, std::size_t second, std::size_t number_of_faces)
  {
    const std::uint64_t key = static_cast<std::uint64_t>(first) * number_of_faces + second;
    const auto [position, is_new] = m_cell_of_key.emplace(key, m_cells.size());
    if (is_new)
      m_cells.push_back(Cell{first, second, Count_and_area()});
    return m_cells[position->second];
  }

  Count_and_area m_total;
  std::vector<Count_and_area> m_first;
  std::vector<Count_and_area> m_second;
  std::vector<Cell> m_cells;
  std::unordered_map<std::uint64_t, std::size_t> m_cell_of_key;
};

// By the number of faces only: all areas are 0.
template <typename FaceGraph, typename SegmentIdMap, typename ReferenceIdMap>
Segment_overlap segment_overlap(const FaceGraph& mesh,
                                const SegmentIdMap& segment_ids,
                                const ReferenceIdMap& reference_ids)
{
  // Not `num_faces(mesh)`, which counts removed faces of a `Surface_mesh`, too.
  const std::vector<std::size_t> numbers = compact_segment_ids(mesh, segment_ids);
  return Segment_overlap(numbers, compact_segment_ids(mesh, reference_ids),
                         std::vector<double>(numbers.size(), 0.));
}

// `face_areas` in the order of `faces(mesh)`.
template <typename FaceGraph, typename SegmentIdMap, typename ReferenceIdMap>
Segment_overlap segment_overlap(const FaceGraph& mesh,
                                const SegmentIdMap& segment_ids,
                                const ReferenceIdMap& reference_ids,
                                const std::vector<double>& face_areas)
{
  return Segment_overlap(compact_segment_ids(mesh, segment_ids), compact_segment_ids(mesh, reference_ids),
                         face_areas);
}

// Which segments are parts, by their numbers: those whose id is not negative.
template <typename FaceGraph, typename SegmentIdMap>
std::vector<bool> segments_that_are_parts(const FaceGraph& mesh, const SegmentIdMap& segment_ids)
{
  using Id = typename boost::property_traits<SegmentIdMap>::value_type;

  const std::vector<std::size_t> numbers = compact_segment_ids(mesh, segment_ids);
  std::vector<bool> result(numbers.size(), true);
  if constexpr (std::is_signed_v<Id>)
  {
    std::size_t i = 0;
    for (const auto f : faces(mesh))
      result[numbers[i++]] = get(segment_ids, f) >= 0;
  }
  return result;
}

// n * (n - 1) / 2, halved before it can overflow; n - 1 may wrap for n = 0, which is multiplied by 0
inline std::uint64_t number_of_pairs(std::uint64_t n)
{
  return n % 2 == 0 ? n / 2 * (n - 1) : n * ((n - 1) / 2);
}

inline std::uint64_t number_of_pairs_within(const std::vector<Count_and_area>& segments)
{
  std::uint64_t sum = 0;
  for (const Count_and_area& segment : segments)
    sum += number_of_pairs(segment.count);
  return sum;
}

// The part of the pairs of faces that only one of the segmentations has in one segment.
inline double rand_index_error(const Segment_overlap& overlap)
{
  const std::uint64_t n = overlap.total().count;
  if (n < 2)
    return 0;

  std::uint64_t pairs_in_both = 0;
  for (const Segment_overlap::Cell& cell : overlap.cells())
    pairs_in_both += number_of_pairs(cell.common.count);
  const std::uint64_t disagreements = number_of_pairs_within(overlap.first_segments()) +
                                      number_of_pairs_within(overlap.second_segments()) -
                                      2 * pairs_in_both;
  CGAL_assertion(disagreements <= number_of_pairs(n));
  return static_cast<double>(disagreements) / static_cast<double>(number_of_pairs(n));
}

// Area outside the best match of each segment, where `largest` are the areas of those matches. Rounding does not make a
// perfect match worse than perfect: the area of a segment and that of a match with all of it are the same sum.
inline double unmatched_rate(double area, const std::vector<Count_and_area>& segments, const std::vector<double>& largest)
{
  double unmatched = 0;
  for (std::size_t s = 0; s < segments.size(); ++s)
    unmatched += (std::max)(0., segments[s].area - largest[s]);
  return area > 0 ? unmatched / area : 0;
}

inline Hamming_distance hamming_distance(const Segment_overlap& overlap)
{
  std::vector<double> largest_of_first(overlap.first_segments().size(), 0.);
  std::vector<double> largest_of_second(overlap.second_segments().size(), 0.);
  for (const Segment_overlap::Cell& cell : overlap.cells())
  {
    double& of_first = largest_of_first[cell.first];
    of_first = (std::max)(of_first, cell.common.area);
    double& of_second = largest_of_second[cell.second];
    of_second = (std::max)(of_second, cell.common.area);
  }

  Hamming_distance result;
  result.missing_rate = unmatched_rate(overlap.total().area, overlap.second_segments(), largest_of_second);
  result.false_alarm_rate = unmatched_rate(overlap.total().area, overlap.first_segments(), largest_of_first);
  result.distance = (result.missing_rate + result.false_alarm_rate) / 2;
  return result;
}

// By the number of faces, as those who use this metric have it. `is_part` says which segments of the second segmentation count.
inline double mean_best_intersection_over_union(const Segment_overlap& overlap, const std::vector<bool>& is_part)
{
  std::vector<double> best(overlap.second_segments().size(), 0.);
  for (const Segment_overlap::Cell& cell : overlap.cells())
  {
    const std::uint64_t all = overlap.first_segments()[cell.first].count +
                              overlap.second_segments()[cell.second].count - cell.common.count;
    best[cell.second] = (std::max)(best[cell.second], double(cell.common.count) / double(all));
  }
  double sum = 0;
  std::size_t number_of_parts = 0;
  for (std::size_t s = 0; s < best.size(); ++s)
    if (is_part[s])
    {
      sum += best[s];
      ++number_of_parts;
    }
  return number_of_parts == 0 ? 1 : sum / double(number_of_parts);
}

// Part of a segment outside another; a segment without area has no part outside.
inline double part_outside(double common, double whole)
{
  return whole > 0 ? (std::max)(0., 1 - common / whole) : 0;
}

// Sums over the faces of the parts of their segments that lie outside the other one.
struct Refinement_errors
{
  double of_first = 0;
  double of_second = 0;
  double of_smaller = 0;

  void add(double weight, double outside_first, double outside_second)
  {
    of_first += weight * outside_first;
    of_second += weight * outside_second;
    of_smaller += weight * (std::min)(outside_first, outside_second);
  }
};

inline Consistency_error consistency_error(const Segment_overlap& overlap)
{
  Consistency_error result;
  if (overlap.total().count == 0)
    return result;

  Refinement_errors by_faces, by_area;
  for (const Segment_overlap::Cell& cell : overlap.cells())
  {
    const Count_and_area& first = overlap.first_segments()[cell.first];
    const Count_and_area& second = overlap.second_segments()[cell.second];
    const double count = static_cast<double>(cell.common.count);
    by_faces.add(count, part_outside(count, static_cast<double>(first.count)),
                 part_outside(count, static_cast<double>(second.count)));
    // Weighted by the number of faces here too: so does the benchmark.
    by_area.add(count, part_outside(cell.common.area, first.area),
                part_outside(cell.common.area, second.area));
  }

  const double n = static_cast<double>(overlap.total().count);
  result.global = (std::min)(by_faces.of_first, by_faces.of_second) / n;
  result.local = by_faces.of_smaller / n;
  result.global_by_area = (std::min)(by_area.of_first, by_area.of_second) / n;
  result.local_by_area = by_area.of_smaller / n;
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_OVERLAP_ERRORS_H
