// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Test meshes as surfaces in index arrays, and brute force on their dual graphs.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_INDEXED_SURFACES_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_INDEXED_SURFACES_H

#include "test_mesh.h"

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <boost/range/iterator_range.hpp>

#include <limits>

namespace test_meshes {

using CGAL::Protrusion_segmentation::Execution;
using CGAL::Protrusion_segmentation::Indexed_surface;
using Index = Indexed_surface::Index;

constexpr double infinity = std::numeric_limits<double>::infinity();

// For what is used alone, outside of a segmentation: nobody listens and nobody stops it.
inline Execution& quiet_execution()
{
  static Execution execution;
  return execution;
}

// `mesh` with its coordinates as they are; also meshes that no halfedge structure holds, such as the
// Moebius strip. Two faces at most share an edge.
inline Indexed_surface to_surface(const Test_mesh& mesh)
{
  std::map<Edge, std::vector<Index>> faces_of_edge;
  const auto edge = [](const Face& face, std::size_t i) -> Edge
  { return std::minmax(face[i], face[(i + 1) % face.size()]); };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t i = 0; i < mesh.faces[f].size(); ++i)
      faces_of_edge[edge(mesh.faces[f], i)].push_back(Index(f));

  std::vector<Indexed_surface::Point_3> points;
  for (const Point& p : mesh.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<Index> corner_begin(1, 0), corner_vertices, corner_neighbors;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const Face& face = mesh.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const std::vector<Index>& sharing = faces_of_edge[edge(face, i)];
      corner_vertices.push_back(Index(face[i]));
      corner_neighbors.push_back(sharing.size() < 2 ? Indexed_surface::no_face()
                                 : sharing[0] == f  ? sharing[1]
                                                    : sharing[0]);
    }
    corner_begin.push_back(Index(corner_vertices.size()));
  }
  return Indexed_surface(std::move(points), std::move(corner_begin), std::move(corner_vertices),
                         std::move(corner_neighbors));
}

// The distances of all pairs of faces on the dual graph, by the algorithm of Floyd and Warshall.
inline std::vector<std::vector<double>> all_pairs_distances(const Indexed_surface& surface)
{
  const std::size_t n = surface.number_of_faces();
  std::vector<std::vector<double>> d(n, std::vector<double>(n, infinity));
  const auto& graph = surface.dual_graph();
  for (const auto arc : boost::make_iterator_range(edges(graph)))
  {
    double& length = d[source(arc, graph)][target(arc, graph)];
    length = (std::min)(length, graph[arc].length);
  }
  for (std::size_t i = 0; i < n; ++i)
    d[i][i] = 0;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        d[i][j] = (std::min)(d[i][j], d[i][k] + d[k][j]);
  return d;
}

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_INDEXED_SURFACES_H
