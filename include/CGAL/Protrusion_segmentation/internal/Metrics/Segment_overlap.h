// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the segments of two segmentations of one mesh overlap: the sparse contingency table from
// which the Rand index error, the Hamming distance and the consistency errors are read off.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_SEGMENT_OVERLAP_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_SEGMENT_OVERLAP_H

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

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
struct Face_measure
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
    Face_measure common;
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

  const Face_measure& total() const { return m_total; }
  const std::vector<Face_measure>& first_segments() const { return m_first; }
  const std::vector<Face_measure>& second_segments() const { return m_second; }
  // in the order of first appearance, which makes sums over them deterministic
  const std::vector<Cell>& cells() const { return m_cells; }

private:
  static void add_to(std::vector<Face_measure>& segments, std::size_t number, double face_area)
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
      m_cells.push_back(Cell{first, second, Face_measure()});
    return m_cells[position->second];
  }

  Face_measure m_total;
  std::vector<Face_measure> m_first;
  std::vector<Face_measure> m_second;
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

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_SEGMENT_OVERLAP_H
