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

#include <cstdlib>
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
  Randomized_cuts_options o; // EXPERIMENT
  auto env = [](const char* n, double d) { const char* v = std::getenv(n); return v ? std::atof(v) : d; };
  o.faces = std::size_t(env("RC_FACES", double(o.faces))); o.cuts = std::size_t(env("RC_CUTS", double(o.cuts)));
  o.places = std::size_t(env("RC_PLACES", double(o.places))); o.exponent = env("RC_EXP", o.exponent);
  o.least_share = env("RC_LOW", o.least_share); o.largest_share = env("RC_HIGH", o.largest_share);
  o.choice = int(env("RC_CHOICE", o.choice));
  return {{"Randomized-cuts", [o](const Mesh& mesh, std::size_t number_of_segments, unsigned int seed)
                              { return randomized_cuts_segmentation(mesh, number_of_segments, seed, o); }},
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
