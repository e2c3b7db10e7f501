// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peers.h"

#include "Face_distance_graph.h"
#include "core_extraction.h"
#include "k_means.h"
#ifdef PROTRUSION_SEGMENTATION_HAS_PCL
#include "planar_cuts.h"
#endif
#include "randomized_cuts.h"
#include "spectral_cuts.h"

#include <random>

namespace {

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

std::vector<Segmentation_method> clustering_methods()
{
  return {{"Randomized-cuts", [](const Mesh& mesh, std::size_t number_of_segments, unsigned int seed)
                              { return randomized_cuts_segmentation(mesh, number_of_segments, seed); }},
          {"Spectral-cuts", [](const Mesh& mesh, std::size_t number_of_segments, unsigned int)
                            { return spectral_cuts_segmentation(mesh, number_of_segments); }},
#ifdef PROTRUSION_SEGMENTATION_HAS_PCL
          {"Planar-cuts", [](const Mesh& mesh, std::size_t number_of_segments, unsigned int seed)
                          { return planar_cuts_segmentation(mesh, number_of_segments, seed); }},
#endif
          {"Core-extraction", [](const Mesh& mesh, std::size_t number_of_segments, unsigned int)
                              { return core_extraction_segmentation(mesh, number_of_segments); }},
          {"K-Means", [](const Mesh& mesh, std::size_t number_of_segments, unsigned int seed)
                      { return k_means_segmentation(mesh, number_of_segments, seed); }},
          {"Voronoi", voronoi_segmentation},
          {"One-segment", [](const Mesh& mesh, std::size_t, unsigned int)
                          { return Labels(mesh.number_of_faces(), 0); }}};
}
