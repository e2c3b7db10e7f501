// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/smooth_borders.h"

#include <CGAL/Protrusion_segmentation/internal/Metrics/face_areas.h>
#include <CGAL/Protrusion_segmentation/smooth_segment_borders.h>

#include <boost/property_map/property_map.hpp>

#include <map>

namespace tool
{

Smoothed_mesh smooth_borders(const Mesh& mesh, const std::vector<std::size_t>& segment_ids)
{
  Smoothed_mesh result;
  const auto segments = result.mesh.add_property_map<Face, std::size_t>("f:segment").first;
  const auto old_faces = result.mesh.add_property_map<Face, Face>("f:old_face").first;
  result.number_of_fixed_segments = CGAL::Protrusion_segmentation::smooth_segment_borders(
    mesh, boost::make_iterator_property_map(segment_ids.begin(), get(boost::face_index, mesh)),
    result.mesh, segments, old_faces);
  for (const Face face : faces(result.mesh))
  {
    result.segment_ids.push_back(segments[face]);
    result.old_faces.push_back(old_faces[face]);
  }
  return result;
}

std::vector<std::size_t> segments_of_old_faces(const Smoothed_mesh& smoothed,
                                               std::size_t number_of_old_faces,
                                               std::size_t number_of_segments)
{
  // Only compared with each other: their unit does not matter.
  const auto measures = CGAL::Protrusion_segmentation::internal::face_areas_and_centroids(smoothed.mesh, smoothed.mesh.points());
  std::vector<std::map<std::size_t, double>> areas(number_of_old_faces); // of segments
  for (std::size_t i = 0; i < measures.size(); ++i)
    areas[smoothed.old_faces[i]][smoothed.segment_ids[i]] += measures[i].area;
  std::vector<std::size_t> result, number_of_faces(number_of_segments, 0), most(number_of_segments, number_of_old_faces);
  for (std::size_t face = 0; face < areas.size(); ++face)
  {
    std::size_t largest = areas[face].begin()->first;
    for (const auto& [segment, part] : areas[face])
    {
      if (part > areas[face][largest])
        largest = segment;
      if (most[segment] == number_of_old_faces || part > areas[most[segment]][segment])
        most[segment] = face;
    }
    result.push_back(largest);
    ++number_of_faces[largest];
  }
  for (std::size_t s = 0; s < number_of_segments; ++s)
    if (number_of_faces[s] == 0)
      result[most[s]] = s;
  return result;
}

} // namespace tool
