// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peers.h"

#include "Face_distance_graph.h"
#include "k_means.h"

#include <CGAL/mesh_segmentation.h>

#include <cmath>
#include <random>

namespace {

Labels sdf_segmentation(const Mesh& mesh, std::size_t number_of_clusters, double smoothness)
{
  std::vector<double> diameters(mesh.number_of_faces(), 0.);
  CGAL::sdf_values(mesh, CGAL::make_property_map(diameters));
  // A face without area has none, and not a number would spread to all others.
  for(double& diameter : diameters)
    if(!std::isfinite(diameter))
      diameter = 0;
  Labels labels(mesh.number_of_faces(), 0);
  CGAL::segmentation_from_sdf_values(mesh, CGAL::make_property_map(diameters),
                                     CGAL::make_property_map(labels), number_of_clusters,
                                     smoothness);
  return labels;
}

Labels voronoi_segmentation(const Mesh& mesh, std::size_t number_of_segments, unsigned int seed)
{
  const Face_distance_graph graph(mesh, [&](Halfedge h) { return centroid_distance(mesh, h); });
  std::mt19937 random(seed);
  // Far from anything, which is a tip most often, rather than anywhere.
  const std::vector<std::size_t> start =
    graph.farthest_points(random() % mesh.number_of_faces(), 2);
  return graph.nearest(graph.farthest_points(start.back(), number_of_segments));
}

} // namespace

std::vector<Segmentation_method> sdf_methods()
{
  return {{"SDF-5-0.26", [](const Mesh& mesh, std::size_t, unsigned int)
                         { return sdf_segmentation(mesh, 5, 0.26); }},
          {"SDF-3-0.1", [](const Mesh& mesh, std::size_t, unsigned int)
                        { return sdf_segmentation(mesh, 3, 0.1); }}};
}

std::vector<Segmentation_method> clustering_methods()
{
  return {{"K-Means", [](const Mesh& mesh, std::size_t number_of_segments, unsigned int seed)
                      { return k_means_segmentation(mesh, number_of_segments, seed); }},
          {"Voronoi", voronoi_segmentation},
          {"One-segment", [](const Mesh& mesh, std::size_t, unsigned int)
                          { return Labels(mesh.number_of_faces(), 0); }}};
}
