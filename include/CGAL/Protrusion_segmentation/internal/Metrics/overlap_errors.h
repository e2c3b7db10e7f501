// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formulas of the metrics that depend on the overlaps of the segments only.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_OVERLAP_ERRORS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_OVERLAP_ERRORS_H

#include <CGAL/Protrusion_segmentation/Consistency_error.h>
#include <CGAL/Protrusion_segmentation/Hamming_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Metrics/Segment_overlap.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// n * (n - 1) / 2, halved before it can overflow; n - 1 may wrap for n = 0, which is multiplied by 0
inline std::uint64_t number_of_pairs(std::uint64_t n)
{
  return n % 2 == 0 ? n / 2 * (n - 1) : n * ((n - 1) / 2);
}

inline std::uint64_t number_of_pairs_within(const std::vector<Face_measure>& segments)
{
  std::uint64_t sum = 0;
  for (const Face_measure& segment : segments)
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
inline double unmatched_rate(double area, const std::vector<Face_measure>& segments, const std::vector<double>& largest)
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
    const Face_measure& first = overlap.first_segments()[cell.first];
    const Face_measure& second = overlap.second_segments()[cell.second];
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

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_OVERLAP_ERRORS_H
