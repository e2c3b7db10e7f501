// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEIGHBOR_LABELS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEIGHBOR_LABELS_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/choose_faces.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Gives polygons that are no faces the label of a neighbour: a face that shares an edge with it, or a corner, or else the one
// before it.
class Neighbor_labels
{
public:
  // `polygon_of_face` is ascending. The arguments must outlive the object.
  Neighbor_labels(const Polygons& polygons,
                  const std::vector<std::size_t>& places,
                  const std::vector<std::size_t>& polygon_of_face)
    : m_polygons(polygons),
      m_places(places),
      m_polygon_of_face(polygon_of_face)
  {}

  // Sets those that are none.
  void complete(std::vector<std::size_t>& face_of_polygon)
  {
    collect_neighbors(face_of_polygon);
    for (std::size_t polygon = 0; polygon < m_polygons.size(); ++polygon)
      if (face_of_polygon[polygon] == none())
        face_of_polygon[polygon] = neighbor_of(polygon);
  }

private:
  static constexpr std::size_t none() { return Face_choice::none(); }

  // More faces than that at one place are not asked for their label.
  static constexpr std::size_t enough_neighbors = 64;

  std::set<std::size_t> places_at(std::size_t polygon) const
  {
    const std::vector<std::size_t> all = places_of(m_polygons[polygon], m_places);
    return std::set<std::size_t>(all.begin(), all.end());
  }

  void collect_neighbors(const std::vector<std::size_t>& face_of_polygon)
  {
    for (std::size_t polygon = 0; polygon < m_polygons.size(); ++polygon)
      if (face_of_polygon[polygon] == none())
        for (const std::size_t place : places_at(polygon))
          m_faces_at[place];
    for (std::size_t face = 0; face < m_polygon_of_face.size() && !m_faces_at.empty(); ++face)
      for (const std::size_t place : places_at(m_polygon_of_face[face]))
        if (const auto found = m_faces_at.find(place);
            found != m_faces_at.end() && found->second.size() < enough_neighbors)
          found->second.push_back(face);
  }

  // The face that shares the most places, of several the first.
  std::size_t neighbor_of(std::size_t polygon) const
  {
    std::map<std::size_t, std::size_t> shared;
    for (const std::size_t place : places_at(polygon))
      for (const std::size_t face : m_faces_at.at(place))
        ++shared[face];
    std::pair<std::size_t, std::size_t> best = {none(), 0};
    for (const auto& candidate : shared)
      if (candidate.second > best.second)
        best = candidate;
    return best.first != none() ? best.first : face_beside(polygon);
  }

  // The last face before the polygon, or the first of all.
  std::size_t face_beside(std::size_t polygon) const
  {
    const auto after = std::lower_bound(m_polygon_of_face.begin(), m_polygon_of_face.end(), polygon);
    const std::size_t before = std::size_t(after - m_polygon_of_face.begin());
    return before > 0 ? before - 1 : 0;
  }

  const Polygons& m_polygons;
  const std::vector<std::size_t>& m_places;
  const std::vector<std::size_t>& m_polygon_of_face;
  std::unordered_map<std::size_t, std::vector<std::size_t>>
    m_faces_at; // at the places of polygons that need a label
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_NEIGHBOR_LABELS_H
