// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_MAKE_CANONICAL_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_MAKE_CANONICAL_SURFACE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Canonical_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/canonical_frame.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Two zero bits behind each of the lower 21 bits.
inline std::uint64_t spread_bits(std::uint64_t bits)
{
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x001f00000000ffff;
  bits = (bits | bits << 16) & 0x001f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

// The place of a point of [-1, 1]^3 on the Z-order curve through a grid of 2^21 cells in each direction.
inline std::uint64_t z_order(const Indexed_surface::Point_3& p)
{
  constexpr double cells = 1 << 21;
  const auto cell = [](double x)
  { return static_cast<std::uint64_t>((std::min)((std::max)((x + 1) / 2, 0.) * cells, cells - 1)); };
  return spread_bits(cell(p.x())) | spread_bits(cell(p.y())) << 1 | spread_bits(cell(p.z())) << 2;
}

inline Indexed_surface::Point_3 mean_of_corners(const Surface_arrays& surface,
                                                Indexed_surface::Index face)
{
  const Indexed_surface::Index first = surface.first_corner(face), end = surface.first_corner(face + 1);
  const Indexed_surface::Point_3& origin = surface.point(surface.vertex(first));
  Indexed_surface::Vector_3 sum(0, 0, 0);
  for (Indexed_surface::Index c = first + 1; c < end; ++c)
    sum += surface.point(surface.vertex(c)) - origin;
  return origin + sum / static_cast<double>(end - first);
}

// The faces in the order of their centres on the Z-order curve. The stages work in this order, so that a tie
// is decided by where a face is and not by its place in a file, sums are rounded alike, and neighbours on the
// surface are near in memory. Only faces with the same centre stay in the order of the mesh.
inline std::vector<Indexed_surface::Index> canonical_order(const Surface_arrays& surface,
                                                           bool is_parallel = false)
{
  using Index = Indexed_surface::Index;
  using Place = std::pair<std::uint64_t, Index>;
  std::vector<Place> places(surface.number_of_faces());
  for_each_number(places.size(), is_parallel,
                  [&](Index f) {
                    places[f] = {z_order(mean_of_corners(surface, f)), f};
                  });
  const auto less = [&surface](const Place& a, const Place& b)
  {
    if (a.first != b.first)
      return a.first < b.first;
    const Indexed_surface::Point_3 p = mean_of_corners(surface, a.second);
    const Indexed_surface::Point_3 q = mean_of_corners(surface, b.second);
    return p != q ? p < q : a.second < b.second;
  };
  sort_different(places, is_parallel, less);
  std::vector<Index> order;
  order.reserve(places.size());
  for (const Place& place : places)
    order.push_back(place.second);
  return order;
}

CGAL_PROTRUSION_SEGMENTATION_INLINE
Canonical_surface::Canonical_surface(Surface_arrays arrays, bool is_parallel)
  : m_unit(move_to_canonical_frame(arrays, is_parallel)), m_position(canonical_order(arrays, is_parallel))
{
  take_in_order(arrays, is_parallel);
}

CGAL_PROTRUSION_SEGMENTATION_INLINE
Canonical_surface::Canonical_surface(Surface_without_small_components rest, bool is_parallel)
  : m_unit(rest.is_connected ? move_to_canonical_frame(rest.arrays, is_parallel)
                             : normalize(rest.arrays.points)),
    m_position(canonical_order(rest.arrays, is_parallel))
{
  take_in_order(rest.arrays, is_parallel);
  if (rest.nearest_faces.empty())
    return;
  for (Index& position : m_position)
    position = rest.faces[position];
  m_face_at = gather(m_face_at, rest.nearest_faces);
}

CGAL_PROTRUSION_SEGMENTATION_INLINE
void Canonical_surface::take_in_order(Surface_arrays& arrays, bool is_parallel)
{
  Surface_arrays ordered = Face_selector<Surface_arrays>(arrays, is_parallel)(m_position);
  arrays = {}; // before memory is needed for more
  m_surface = std::move(ordered).to_surface(is_parallel);
  m_face_at.resize(m_position.size());
  for (Index f = 0; f < m_position.size(); ++f)
    m_face_at[m_position[f]] = f;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_MAKE_CANONICAL_SURFACE_H
