// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_RADIAL_ORDER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_RADIAL_ORDER_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Parity_sets.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Signed_volume.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// For each polygon: a name of those that it is connected to by corners at the same place; 0 without corners.
inline std::vector<std::size_t> clusters_of_polygons(const Polygons& polygons,
                                                     const std::vector<std::size_t>& places)
{
  Parity_sets sets(places.size());
  for (std::size_t i = 0; i < polygons.size(); ++i)
    for (const std::size_t corner : polygons[i])
      sets.unite(places[polygons[i].front()], places[corner], false);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < polygons.size(); ++i)
    result.push_back(polygons[i].empty() ? 0 : sets.find(places[polygons[i].front()]).first);
  return result;
}

// For each polygon: is the set that it belongs to turned inside out? Its volume is negative then. Sets have numbers below
// `number_of_sets`.
inline std::vector<bool> are_inside_out(const std::vector<Polygon_soup::Point_3>& points,
                                        const Polygons& polygons,
                                        const std::vector<std::size_t>& sets,
                                        std::size_t number_of_sets)
{
  std::vector<Signed_volume> volumes(number_of_sets);
  for (std::size_t i = 0; i < polygons.size(); ++i)
    volumes[sets[i]].add(of_corners(points, polygons[i]));
  std::vector<bool> result;
  for (const std::size_t s : sets)
    result.push_back(volumes[s].orientation() < 0);
  return result;
}

// A face at an edge, seen along the edge.
struct Face_at_edge
{
  double angle;         // where it is, counterclockwise
  bool is_solid_before; // whether its solid is at smaller angles
  std::size_t side;
};

// In the order around their edge. Two faces that lie on each other are a wall: the solid before it ends before the next one
// begins.
inline void sort_around_edge(std::vector<Face_at_edge>& faces)
{
  constexpr double equal_angles = 1e-4; // coordinates in single precision give angles to that
  std::sort(faces.begin(), faces.end(),
            [](const Face_at_edge& a, const Face_at_edge& b)
            { return std::make_pair(a.angle, a.side) < std::make_pair(b.angle, b.side); });
  const auto gap_before = [&](std::size_t i)
  {
    return i > 0 ? faces[i].angle - faces[i - 1].angle
                 : faces[0].angle - faces.back().angle + 2 * CGAL_PI;
  };
  std::size_t widest = 0; // no wall lies in this gap
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (gap_before(i) > gap_before(widest))
      widest = i;
  for (std::size_t i = 0; i < widest; ++i)
    faces[i].angle += 2 * CGAL_PI;
  std::rotate(faces.begin(), faces.begin() + std::ptrdiff_t(widest), faces.end());
  for (auto begin = faces.begin(), end = begin; begin != faces.end(); begin = end)
  {
    end = std::adjacent_find(begin, faces.end(),
                             [](const Face_at_edge& a, const Face_at_edge& b)
                             { return b.angle - a.angle > equal_angles; });
    end += end != faces.end() ? 1 : 0;
    std::stable_partition(begin, end, [](const Face_at_edge& face) { return face.is_solid_before; });
  }
}

// The pairs of sides between which a solid lies. None if the faces do not bound solids: some look the wrong way then.
inline std::vector<std::array<std::size_t, 2>> sides_of_solids(std::vector<Face_at_edge> faces)
{
  std::vector<std::array<std::size_t, 2>> result;
  const auto ends = std::count_if(faces.begin(), faces.end(),
                                  [](const Face_at_edge& face) { return face.is_solid_before; });
  if (2 * std::size_t(ends) != faces.size())
    return result;
  sort_around_edge(faces);
  std::vector<std::size_t> begun; // solids
  std::vector<bool> is_paired(faces.size(), false);
  for (std::size_t round = 0; round < 2; ++round) // what begins in the first one may end in the second
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (!faces[i].is_solid_before && round == 0)
        begun.push_back(faces[i].side);
      else if (faces[i].is_solid_before && !is_paired[i] && !begun.empty())
      {
        result.push_back({begun.back(), faces[i].side});
        begun.pop_back();
        is_paired[i] = true;
      }
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_RADIAL_ORDER_H
