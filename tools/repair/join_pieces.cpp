// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Format_error.h"
#include "repair/Input_mesh.h"

#include <CGAL/Protrusion_segmentation/internal/Repair/labels_of_pieces.h>
#include <CGAL/Protrusion_segmentation/join_pieces.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace tool {
namespace {

// For each vertex of the mesh: a corner of a face of the file that is nearest to a face around it.
std::vector<std::size_t> nearest_corners(const Input_mesh& input)
{
  std::vector<std::size_t> result;
  for (const auto v : input.mesh.vertices())
  {
    const Corners polygon =
      input.soup.polygons[input.face_in_file[input.mesh.face(input.mesh.halfedge(v))]];
    const auto distance = [&](std::size_t point)
    { return CGAL::squared_distance(input.soup.points[point], input.mesh.point(v)); };
    result.push_back(*std::min_element(polygon.begin(), polygon.end(),
                                       [&](std::size_t a, std::size_t b)
                                       { return distance(a) < distance(b); }));
  }
  return result;
}

} // namespace

Input_mesh join_pieces(Polygon_soup soup, std::optional<double> gap)
{
  const bool has_area = std::any_of(soup.polygons.begin(), soup.polygons.end(),
                                    [&](const Corners& polygon)
                                    {
                                      for (std::size_t i = 2; i < polygon.size(); ++i)
                                        if (!CGAL::collinear(soup.points[polygon[0]],
                                                             soup.points[polygon[i - 1]],
                                                             soup.points[polygon[i]]))
                                          return true;
                                      return false;
                                    });
  if (!has_area)
    throw Format_error("has no faces with an area, which could be joined");
  Input_mesh input;
  input.soup = std::move(soup);
  auto joined = CGAL::Protrusion_segmentation::join_pieces(input.soup.points, input.soup.polygons,
                                                           input.mesh, gap);
  input.label_giver.assign(joined.face_of_polygon.begin(), joined.face_of_polygon.end());
  input.face_in_file.assign(joined.polygon_of_face.begin(), joined.polygon_of_face.end());
  input.point_of_vertex = nearest_corners(input);
  input.repairs.components = joined.repairs.components;
  input.pieces = std::move(joined.piece_of_polygon);
  input.areas = std::move(joined.area_of_polygon);
  return input;
}

std::vector<std::size_t> patches_of_mesh(const Input_mesh& input)
{
  std::vector<std::size_t> patches;
  if (input.has_joined_pieces())
    std::transform(input.face_in_file.begin(), input.face_in_file.end(), std::back_inserter(patches),
                   [&](std::size_t face) { return input.pieces[face]; });
  return patches;
}

std::vector<std::size_t> labels_of_file(const std::vector<std::size_t>& labels_of_mesh,
                                        const Input_mesh& input)
{
  if (input.has_joined_pieces())
    return CGAL::Protrusion_segmentation::internal::labels_of_pieces(
      labels_of_mesh, {input.label_giver.begin(), input.label_giver.end()},
      {input.face_in_file.begin(), input.face_in_file.end()}, input.pieces, input.areas);
  std::vector<std::size_t> result;
  result.reserve(input.label_giver.size());
  for (const std::size_t face : input.label_giver)
    result.push_back(labels_of_mesh[face]);
  return result;
}

} // namespace tool
