// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortest paths over the faces of a mesh, for the peers: with arcs as long as they need them.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_FACE_DISTANCE_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_FACE_DISTANCE_GRAPH_H

#include "Segmentation_method.h"

#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

class Face_distance_graph
{
public:
  // `length(h)` of the arc between the two faces at the halfedge `h`.
  Face_distance_graph(const Mesh& mesh, const std::function<double(Halfedge)>& length);

  std::size_t number_of_faces() const { return num_vertices(m_graph); }

  // Distance of each face to the nearest of `sources`; infinite if none can be reached.
  std::vector<double> distances(const std::vector<std::size_t>& sources) const;

  // Distances from `source` along faces with the label of `source` only; infinite elsewhere.
  std::vector<double> distances_within(const Labels& labels, std::size_t source) const;

  // The index of the nearest of `seeds` for each face; the first seed where none can be reached.
  Labels nearest(const std::vector<std::size_t>& seeds) const;

  // `number` faces: `first`, then always the face that is farthest from those chosen before.
  std::vector<std::size_t> farthest_points(std::size_t first, std::size_t number) const;

private:
  using Graph = boost::compressed_sparse_row_graph<boost::directedS,
                                                   boost::no_property,
                                                   boost::property<boost::edge_weight_t, double>>;
  using Weighted_face = std::pair<double, std::size_t>;
  // Called when the final distance of a face is known, with the face it was reached from.
  using Settled = std::function<void(std::size_t face, std::size_t from)>;

  std::vector<double> search(const std::vector<std::size_t>& sources,
                             const std::function<bool(std::size_t)>& may_enter,
                             const Settled& settled) const;

  Graph m_graph;
};

// The distance of the paper's section III.B between adjacent faces: that of their centroids.
double centroid_distance(const Mesh& mesh, Halfedge h);

// Of a triangle; the benchmark has no other faces.
Point face_centroid(const Mesh& mesh, Face f);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_FACE_DISTANCE_GRAPH_H
