// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/smooth_borders.h"

#include <CGAL/Protrusion_segmentation/internal/Metrics/face_measures.h>
#include <CGAL/Protrusion_segmentation/smooth_segment_borders.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <map>

namespace tool
{
namespace
{

template <typename Points>
double area(const Mesh& mesh, const Points& points, Face face)
{
  CGAL::Simple_cartesian<double>::Vector_3 sum(0, 0, 0);
  const auto h = mesh.halfedge(face);
  const Point first = points(mesh.source(h));
  for (auto g = mesh.next(h); mesh.target(g) != mesh.source(h); g = mesh.next(g))
    sum = sum + CGAL::cross_product(points(mesh.source(g)) - first, points(mesh.target(g)) - first);
  return std::sqrt(sum.squared_length()) / 2;
}

} // namespace

Smoothed_mesh smooth_borders(const Mesh& mesh, const std::vector<std::size_t>& segment_ids)
{
  Smoothed_mesh result;
  const auto segments = result.mesh.add_property_map<Face, std::size_t>("f:segment").first;
  const auto old_faces = result.mesh.add_property_map<Face, Face>("f:old_face").first;
  result.number_of_fixed_segments = CGAL::smooth_segment_borders(
    mesh, boost::make_iterator_property_map(segment_ids.begin(), get(boost::face_index, mesh)), result.mesh, segments,
    old_faces);
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
  // Only compared with each other: the unit does not matter.
  const CGAL::Protrusion_segmentation::internal::Scaled_points points(smoothed.mesh, smoothed.mesh.points());
  std::vector<std::map<std::size_t, double>> areas(number_of_old_faces); // of segments
  for (const Face face : faces(smoothed.mesh))
    areas[smoothed.old_faces[face]][smoothed.segment_ids[face]] += area(smoothed.mesh, points, face);
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
