// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_MESH_TO_CLOSE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_MESH_TO_CLOSE_H

#include <CGAL/Protrusion_segmentation/Closed_segment.h>
#include <CGAL/Protrusion_segmentation/Segmentation_record.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Capper.h>
#include <CGAL/Protrusion_segmentation/internal/Metrics/face_areas.h>
#include <CGAL/Protrusion_segmentation/internal/user_points.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/property_map/transform_value_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A mesh that a user wants to close, with its segments.
template <typename FaceGraph, typename SegmentMap, typename VertexPointMap>
class Copy_to_close
{
public:
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using Face = typename boost::graph_traits<FaceGraph>::face_descriptor;
  using Halfedge = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

  // Throws if a coordinate is not finite.
  Copy_to_close(const FaceGraph& mesh,
                const SegmentMap& segments,
                const Segmentation_record<FaceGraph>& record,
                const VertexPointMap& points)
    : m_points(points)
  {
    const Scaled_points<VertexPointMap> check(mesh, points);
    std::vector<std::pair<Vertex, Mesh_to_close::Vertex_index>> vertices;
    std::vector<std::pair<Face, Mesh_to_close::Face_index>> faces;
    std::vector<std::pair<Halfedge, Mesh_to_close::Halfedge_index>> halfedges;
    const auto points_to_close = boost::make_transform_value_property_map<Mesh_to_close::Point>(
      [](const Point& p) { return to_double_point(p); }, points);
    copy_face_graph(mesh, m_mesh,
                    parameters::vertex_point_map(points_to_close)
                      .vertex_to_vertex_output_iterator(std::back_inserter(vertices))
                      .face_to_face_output_iterator(std::back_inserter(faces))
                      .halfedge_to_halfedge_output_iterator(std::back_inserter(halfedges)));
    for (const auto& [h, copy] : halfedges) // corners begin where they do in the user's mesh
      if (!CGAL::is_border(h, mesh) && halfedge(face(h, mesh), mesh) == h)
        m_mesh.set_halfedge(m_mesh.face(copy), copy);
    m_vertices.resize(vertices.size());
    for (const auto& [vertex, copy] : vertices)
      m_vertices[copy] = vertex;
    m_segment_of_face.resize(faces.size());
    std::size_t end = 0;
    for (const auto& [face, copy] : faces)
    {
      m_segment_of_face[copy] = static_cast<std::size_t>(get(segments, face));
      end = (std::max)(end, m_segment_of_face[copy] + 1);
    }
    for (const auto& protrusion : record.protrusions())
      end = (std::max)({end, protrusion.segment + 1, protrusion.parent + 1});
    for (std::size_t segment = 0; segment < end; ++segment)
      m_parents.push_back(segment);
    for (const auto& protrusion : record.protrusions())
      m_parents[protrusion.segment] = protrusion.parent;
  }

  const Mesh_to_close& mesh() const { return m_mesh; }
  const std::vector<std::size_t>& segment_of_face() const { return m_segment_of_face; }
  const std::vector<std::size_t>& parents() const
  {
    return m_parents;
  } // of the segments; their own for bodies

  // Corners are indices of `points`; the first ones are vertices of the user's mesh and get its points.
  Closed_segment<Point> segment(const std::vector<std::vector<std::size_t>>& polygons,
                                const std::vector<Mesh_to_close::Point>& points) const
  {
    Closed_segment<Point> result;
    std::map<std::size_t, std::size_t> numbers;
    for (const std::vector<std::size_t>& polygon : polygons)
    {
      result.polygons.emplace_back();
      for (const std::size_t corner : polygon)
      {
        const auto [position, is_new] = numbers.emplace(corner, result.points.size());
        if (is_new)
          result.points.push_back(corner < m_vertices.size() ? Point(get(m_points, m_vertices[corner]))
                                                             : to_point(points[corner]));
        result.polygons.back().push_back(position->second);
      }
    }
    return result;
  }

  static Point to_point(const Mesh_to_close::Point& p) { return Point(p.x(), p.y(), p.z()); }

private:
  VertexPointMap m_points;
  Mesh_to_close m_mesh;
  std::vector<Vertex> m_vertices; // of the user's mesh
  std::vector<std::size_t> m_segment_of_face;
  std::vector<std::size_t> m_parents;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_MESH_TO_CLOSE_H
