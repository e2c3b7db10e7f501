// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances along the edges of a mesh from the borders of one segmentation to those of another: the
// part of the cut discrepancy that needs the mesh.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_BORDER_DISTANCES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_BORDER_DISTANCES_H

#include <CGAL/Protrusion_segmentation/internal/Metrics/face_areas.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/two_bit_color_map.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Vertices and edges of the mesh, each edge in both directions with its length in the unit of `Scaled_points`.
using Edge_length = boost::property<boost::edge_weight_t, double>;
using Vertex_graph =
  boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Edge_length>;

template <typename FaceGraph, typename VertexPointMap, typename VertexIndexMap>
Vertex_graph vertex_graph(const FaceGraph& mesh,
                          const VertexPointMap& vertex_points,
                          const VertexIndexMap& vertex_indices)
{
  const Scaled_points points(mesh, vertex_points);
  std::vector<std::pair<std::size_t, std::size_t>> arcs;
  std::vector<double> lengths;
  arcs.reserve(num_halfedges(mesh));
  lengths.reserve(num_halfedges(mesh));
  for (const auto h : halfedges(mesh))
  {
    const auto s = source(h, mesh);
    const auto t = target(h, mesh);
    arcs.emplace_back(get(vertex_indices, s), get(vertex_indices, t));
    lengths.push_back(std::sqrt(CGAL::squared_distance(points(s), points(t))));
  }
  return Vertex_graph(boost::edges_are_unsorted_multi_pass, arcs.begin(), arcs.end(), lengths.begin(),
                      num_vertices(mesh));
}

// Indices of the vertices on a border: ends of an edge between two segments. Edges with a face on
// one side only separate nothing.
template <typename FaceGraph, typename SegmentIdMap, typename VertexIndexMap>
std::vector<std::size_t> border_vertices(const FaceGraph& mesh,
                                         const SegmentIdMap& segment_ids,
                                         const VertexIndexMap& vertex_indices)
{
  std::vector<char> is_on_border(num_vertices(mesh), 0);
  std::vector<std::size_t> result;
  for (const auto e : edges(mesh))
  {
    if (CGAL::is_border(e, mesh))
      continue;
    const auto h = halfedge(e, mesh);
    if (get(segment_ids, face(h, mesh)) == get(segment_ids, face(opposite(h, mesh), mesh)))
      continue;
    for (const auto v : {source(h, mesh), target(h, mesh)})
    {
      const std::size_t index = get(vertex_indices, v);
      if (!is_on_border[index])
        result.push_back(index);
      is_on_border[index] = 1;
    }
  }
  return result;
}

// Of each vertex to the nearest of `border`; infinite where none can be reached.
inline std::vector<double> distances_to_border(const Vertex_graph& graph,
                                               const std::vector<std::size_t>& border)
{
  std::vector<double> distances(num_vertices(graph));
  const auto indices = get(boost::vertex_index, graph);
  boost::dijkstra_shortest_paths(
    graph, border.begin(), border.end(), boost::dummy_property_map(),
    boost::make_iterator_property_map(distances.begin(), indices), get(boost::edge_weight, graph),
    indices, std::less<double>(), boost::closed_plus<double>(), std::numeric_limits<double>::infinity(),
    0., boost::default_dijkstra_visitor(), boost::make_two_bit_color_map(num_vertices(graph), indices));
  return distances;
}

// The points of a border, and how far all vertices are from them.
struct Border
{
  std::vector<std::size_t> points;
  std::vector<double> distances;
};

inline double sum_of_distances(const std::vector<std::size_t>& points, const Border& border)
{
  double sum = 0;
  for (const std::size_t point : points)
    sum += border.distances[point];
  return sum;
}

inline std::optional<double> cut_discrepancy(const Border& first, const Border& second, double radius)
{
  if (first.points.empty() || second.points.empty() || !(radius > 0))
    return std::nullopt;
  const double sum = sum_of_distances(first.points, second) + sum_of_distances(second.points, first);
  if (!std::isfinite(sum))
    return std::nullopt;
  return sum / static_cast<double>(first.points.size() + second.points.size()) / radius;
}

template <typename FaceGraph,
          typename SegmentIdMap,
          typename ReferenceIdMap,
          typename VertexPointMap,
          typename VertexIndexMap>
std::optional<double> cut_discrepancy(const FaceGraph& mesh,
                                      const SegmentIdMap& segment_ids,
                                      const ReferenceIdMap& reference_ids,
                                      const VertexPointMap& vertex_points,
                                      const VertexIndexMap& vertex_indices)
{
  const std::vector<std::size_t> border = border_vertices(mesh, segment_ids, vertex_indices);
  const std::vector<std::size_t> reference = border_vertices(mesh, reference_ids, vertex_indices);
  if (border.empty() || reference.empty())
    return std::nullopt;

  const Vertex_graph graph = vertex_graph(mesh, vertex_points, vertex_indices);
  return cut_discrepancy(Border{border, distances_to_border(graph, border)},
                         Border{reference, distances_to_border(graph, reference)},
                         average_radius(face_areas_and_centroids(mesh, vertex_points)));
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_BORDER_DISTANCES_H
