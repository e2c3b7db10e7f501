// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_of_arrays.h"

#include "reading/Format_error.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace python {
namespace {

std::vector<tool::Point> read_points(const std::vector<double>& xyz)
{
  std::vector<tool::Point> points;
  points.reserve(xyz.size() / 3);
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
    points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
  return points;
}

tool::Polygon read_polygon(const std::vector<std::int64_t>& corners,
                           std::size_t begin,
                           std::size_t end,
                           std::size_t face,
                           std::size_t number_of_vertices)
{
  tool::Polygon polygon;
  for (std::size_t i = begin; i < end; ++i)
  {
    if (corners[i] < 0 || static_cast<std::size_t>(corners[i]) >= number_of_vertices)
      throw std::invalid_argument("faces: face " + std::to_string(face) + " has the corner " +
                                  std::to_string(corners[i]) + ", but there are " +
                                  std::to_string(number_of_vertices) + " vertices");
    polygon.push_back(static_cast<std::size_t>(corners[i]));
  }
  return polygon;
}

tool::Polygons read_polygons(const Arrays& arrays, std::size_t number_of_vertices)
{
  const std::vector<std::int64_t>&corners = arrays.corners, &sizes = arrays.sizes;
  if (sizes.empty())
    throw std::invalid_argument("faces: there are none");
  tool::Polygons polygons;
  polygons.reserve(sizes.size(), corners.size());
  std::size_t begin = 0;
  for (std::size_t face = 0; face < sizes.size(); ++face)
  {
    if (sizes[face] < 0 || static_cast<std::size_t>(sizes[face]) > corners.size() - begin)
      throw std::invalid_argument("faces: there are fewer corners than the faces have");
    const std::size_t end = begin + static_cast<std::size_t>(sizes[face]);
    polygons.add(read_polygon(corners, begin, end, face, number_of_vertices));
    begin = end;
  }
  return polygons;
}

bool has_finite_coordinates(const tool::Point& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

// Points that are no corners do not matter, and move to the origin if they are not finite.
void check_points(tool::Polygon_soup& soup)
{
  for (const tool::Corners& polygon : soup.polygons)
    for (const std::size_t i : polygon)
      if (!has_finite_coordinates(soup.points[i]))
        throw std::invalid_argument("vertices: vertex " + std::to_string(i) +
                                    " has a coordinate that is not finite");
  for (tool::Point& p : soup.points)
    if (!has_finite_coordinates(p))
      p = CGAL::ORIGIN;
}

} // namespace

tool::Input_mesh mesh_of_arrays(const Arrays& arrays)
{
  tool::Polygon_soup soup;
  soup.points = read_points(arrays.coordinates);
  soup.polygons = read_polygons(arrays, soup.points.size());
  check_points(soup);
  try
  {
    return arrays.are_pieces_joined ? tool::join_pieces(std::move(soup), arrays.gap)
                                    : tool::make_input_mesh(std::move(soup), arrays.snapping_tolerance);
  }
  catch (const tool::Format_error& error)
  {
    throw std::invalid_argument(std::string("faces: the mesh ") + error.what());
  }
}

std::vector<std::int64_t> labels_of_mesh(const std::vector<std::int64_t>& labels,
                                         const tool::Input_mesh& input,
                                         const std::string& name)
{
  if (labels.size() != input.label_giver.size())
    throw std::invalid_argument(name + ": there are " + std::to_string(labels.size()) +
                                ", but the mesh has " + std::to_string(input.label_giver.size()) +
                                " faces");
  std::vector<std::int64_t> result;
  for (const std::size_t face : input.face_in_file)
    result.push_back(labels[face]);
  return result;
}

} // namespace python
