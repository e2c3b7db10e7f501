// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_MANIFOLD_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_MANIFOLD_SURFACE_H

#include <CGAL/Protrusion_segmentation/Polygon_soup_correspondence.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/manifold_surface.h>
#include <CGAL/Protrusion_segmentation/internal/user_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Adds a vertex for each of `point_of_vertex`, ascending indices of `points`.
template <typename PointRange, typename PointMap, typename FaceGraph, typename NamedParameters>
std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> add_vertices(
  const PointRange& points,
  const PointMap& point_map,
  const std::vector<std::size_t>& point_of_vertex,
  FaceGraph& output,
  const NamedParameters& output_np)
{
  auto output_points = parameters::choose_parameter(
    parameters::get_parameter(output_np, internal_np::vertex_point), get_property_map(CGAL::vertex_point, output));
  using Point = typename boost::property_traits<decltype(output_points)>::value_type;

  std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> result;
  auto element = std::begin(points);
  std::size_t position = 0;
  for (const std::size_t point : point_of_vertex)
  {
    for (; position < point; ++position)
      ++element;
    result.push_back(add_vertex(output));
    put(output_points, result.back(), point_as<Point>(get(point_map, *element)));
  }
  return result;
}

// Adds a surface that was made of a soup with these points to `output`.
template <typename PointRange, typename PointMap, typename FaceGraph, typename NamedParameters>
Polygon_soup_correspondence<FaceGraph> write_manifold_surface(const PointRange& points,
                                                              const PointMap& point_map,
                                                              Manifold_surface surface,
                                                              FaceGraph& output,
                                                              const NamedParameters& output_np)
{
  using Traits = boost::graph_traits<FaceGraph>;

  Polygon_soup_correspondence<FaceGraph> result;
  result.vertices = add_vertices(points, point_map, surface.point_of_vertex, output, output_np);
  std::vector<typename Traits::vertex_descriptor> corners;
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
  {
    corners.clear();
    for (const std::size_t vertex : surface.faces[f])
      corners.push_back(result.vertices[vertex]);
    result.faces.push_back(Euler::add_face(corners, output));
    CGAL_assertion(result.faces.back() != Traits::null_face()); // the surface is a manifold
  }
  result.face_of_polygon.reserve(surface.face_of_polygon.size());
  for (const std::size_t face : surface.face_of_polygon)
    result.face_of_polygon.push_back(result.faces[face]);
  result.polygon_of_face = std::move(surface.polygon_of_face);
  result.point_of_vertex = std::move(surface.point_of_vertex);
  result.repairs = surface.repairs;
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_MANIFOLD_SURFACE_H
