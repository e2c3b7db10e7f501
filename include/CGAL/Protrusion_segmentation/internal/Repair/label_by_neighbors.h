// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_LABEL_BY_NEIGHBORS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_LABEL_BY_NEIGHBORS_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/choose_faces.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Gives polygons that are no faces the label of a neighbour: the face that shares the most places with it, of several the
// first, or else the last one before it. `polygon_of_face` is ascending. Sets those of `face_of_polygon` that are none.
inline void label_by_neighbors(const Polygons& polygons,
                               const std::vector<std::size_t>& places,
                               const std::vector<std::size_t>& polygon_of_face,
                               std::vector<std::size_t>& face_of_polygon)
{
  constexpr std::size_t enough_neighbors = 64; // more faces at one place are not asked for their label
  const auto places_at = [&](std::size_t polygon)
  {
    const std::vector<std::size_t> all = of_corners(places, polygons[polygon]);
    return std::set<std::size_t>(all.begin(), all.end());
  };
  std::vector<std::size_t> unlabeled;                                 // polygons
  std::unordered_map<std::size_t, std::vector<std::size_t>> faces_at; // their places
  for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon)
    if (face_of_polygon[polygon] == Face_choice::none())
    {
      unlabeled.push_back(polygon);
      for (const std::size_t place : places_at(polygon))
        faces_at[place];
    }
  for (std::size_t face = 0; face < polygon_of_face.size() && !faces_at.empty(); ++face)
    for (const std::size_t place : places_at(polygon_of_face[face]))
      if (const auto found = faces_at.find(place);
          found != faces_at.end() && found->second.size() < enough_neighbors)
        found->second.push_back(face);

  for (const std::size_t polygon : unlabeled)
  {
    std::map<std::size_t, std::size_t> shared; // the number of places, of each face
    for (const std::size_t place : places_at(polygon))
      for (const std::size_t face : faces_at.at(place))
        ++shared[face];
    const auto most = std::max_element(shared.begin(), shared.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    const auto after = std::lower_bound(polygon_of_face.begin(), polygon_of_face.end(), polygon);
    const std::size_t before = std::size_t(after - polygon_of_face.begin());
    face_of_polygon[polygon] = most != shared.end() ? most->first : before > 0 ? before - 1 : 0;
  }
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_LABEL_BY_NEIGHBORS_H
