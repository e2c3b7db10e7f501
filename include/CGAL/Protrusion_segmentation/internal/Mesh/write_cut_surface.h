// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_CUT_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_WRITE_CUT_SURFACE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Cut_surface.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A cut edge is known by its two ends.
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

// Points of an input mesh, and of an output mesh that are means of these.
template <typename FaceGraph, typename VertexPointMap, typename Point>
class Points_of_cut_surface
{
public:
  using Index = Indexed_surface::Index;
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;

  // in the order in which `read_surface()` numbers vertices
  Points_of_cut_surface(const FaceGraph& mesh, const VertexPointMap& points) : m_points(points)
  {
    for (const auto v : vertices(mesh))
      if (halfedge(v, mesh) != boost::graph_traits<FaceGraph>::null_halfedge())
        m_vertices.push_back(v);
  }

  std::size_t number_of_old_vertices() const { return m_vertices.size(); }

  Point old_point(std::size_t i) const
  {
    const auto& p = get(m_points, m_vertices[i]);
    if constexpr (std::is_same<Point, std::decay_t<decltype(p)>>::value)
      return p;
    else
      return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  Point new_point(const Cut_surface::Weights& weights) const
  {
    std::array<double, 3> sum = {0, 0, 0};
    for (const auto& [vertex, weight] : weights)
    {
      const auto& p = get(m_points, m_vertices[vertex]);
      sum[0] += weight * CGAL::to_double(p.x());
      sum[1] += weight * CGAL::to_double(p.y());
      sum[2] += weight * CGAL::to_double(p.z());
    }
    return Point(sum[0], sum[1], sum[2]);
  }

private:
  const VertexPointMap& m_points;
  std::vector<vertex_descriptor> m_vertices;
};

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
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Traits = boost::graph_traits<OutputMesh>;

  const auto points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, mesh));
  auto output_points = choose_parameter(get_parameter(output_np, internal_np::vertex_point),
                                        get_property_map(CGAL::vertex_point, output));
  using Point = typename boost::property_traits<decltype(output_points)>::value_type;
  const Points_of_cut_surface<FaceGraph, std::decay_t<decltype(points)>, Point> cut_points(mesh, points);

  std::vector<typename Traits::vertex_descriptor> vertices_of_output;
  const auto add = [&](const Point& point)
  {
    vertices_of_output.push_back(add_vertex(output));
    put(output_points, vertices_of_output.back(), point);
  };
  for (std::size_t i = 0; i < cut_points.number_of_old_vertices(); ++i)
    add(cut_points.old_point(i));
  for (const Cut_surface::Weights& weights : surface.new_vertices)
    add(cut_points.new_point(weights));

  const std::vector<typename boost::graph_traits<FaceGraph>::face_descriptor> descriptors(faces(mesh).begin(),
                                                                                          faces(mesh).end());
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
