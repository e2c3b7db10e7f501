// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_CUT_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_CUT_SURFACE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Cut_surface.h>
#include <CGAL/Protrusion_segmentation/internal/user_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Throws if two edges have the same two ends: a cut edge is known by its ends.
inline void check_edges_are_single(const Indexed_surface& surface)
{
  using Index = Indexed_surface::Index;
  std::vector<std::pair<Index, Index>> edges;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      edges.emplace_back(surface.vertex(c), surface.vertex(surface.next_corner(f, c)));
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  if (twice != edges.end())
    throw std::invalid_argument("pmesh: two edges have the same two ends");
}

// The point of a new vertex. `vertices` are the old ones.
template <typename Point, typename VertexPointMap, typename Vertex>
Point weighted_mean(const VertexPointMap& points, const std::vector<Vertex>& vertices, const Cut_surface::Weights& weights)
{
  Indexed_surface::Vector_3 sum(0, 0, 0);
  for (const auto& [vertex, weight] : weights)
    sum += weight * (to_double_point(get(points, vertices[vertex])) - ORIGIN);
  return Point(sum.x(), sum.y(), sum.z());
}

// Adds the pieces of the faces of `mesh` to `output`.
template <typename FaceGraph,
          typename Id,
          typename OutputMesh,
          typename OutputSegmentMap,
          typename OldFaceMap,
          typename NamedParameters,
          typename OutputNamedParameters>
void write_cut_surface(const FaceGraph& mesh,
                       const Cut_surface& surface,
                       const std::vector<Id>& ids,
                       OutputMesh& output,
                       OutputSegmentMap& output_segment_ids,
                       OldFaceMap& old_faces,
                       const NamedParameters& np,
                       const OutputNamedParameters& output_np)
{
  using Input_traits = boost::graph_traits<FaceGraph>;
  using Traits = boost::graph_traits<OutputMesh>;

  const auto points = vertex_point_map(mesh, np);
  auto output_points = parameters::choose_parameter(
    parameters::get_parameter(output_np, internal_np::vertex_point), get_property_map(CGAL::vertex_point, output));
  using Point = typename boost::property_traits<decltype(output_points)>::value_type;

  std::vector<typename Traits::vertex_descriptor> vertices_of_output;
  const auto add = [&](const Point& point)
  {
    vertices_of_output.push_back(add_vertex(output));
    put(output_points, vertices_of_output.back(), point);
  };
  std::vector<typename Input_traits::vertex_descriptor> old_vertices; // in the order of `read_surface()`
  for (const auto v : vertices(mesh))
    if (halfedge(v, mesh) != Input_traits::null_halfedge())
    {
      old_vertices.push_back(v);
      add(point_as<Point>(get(points, v)));
    }
  for (const Cut_surface::Weights& weights : surface.new_vertices)
    add(weighted_mean<Point>(points, old_vertices, weights));

  const std::vector<typename Input_traits::face_descriptor> descriptors(faces(mesh).begin(), faces(mesh).end());
  std::vector<typename Traits::vertex_descriptor> corners;
  for (const Cut_surface::Piece& piece : surface.pieces)
  {
    corners.clear();
    for (Indexed_surface::Index v : piece.corners)
      corners.push_back(vertices_of_output[v]);
    const auto f = Euler::add_face(corners, output);
    CGAL_assertion(f != Traits::null_face()); // the pieces are a surface as the faces are
    put(output_segment_ids, f, ids[piece.segment]);
    put(old_faces, f, descriptors[piece.face]);
  }
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_CUT_SURFACE_H
