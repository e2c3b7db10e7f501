// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "k_means.h"

#include "Face_distance_graph.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <algorithm>
#include <limits>
#include <random>

namespace {

// 1 - cos^2 of the angle between the planes of the two faces at a halfedge.
double angular_distance(const Mesh& mesh, Halfedge h)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const double cosine = PMP::compute_face_normal(mesh.face(h), mesh)
                      * PMP::compute_face_normal(mesh.face(mesh.opposite(h)), mesh);
  return 1 - cosine * cosine;
}

double mean_over_edges(const Mesh& mesh, const std::function<double(Halfedge)>& value)
{
  double sum = 0;
  for(const auto e : mesh.edges())
    sum += mesh.is_border(e) ? 0 : value(mesh.halfedge(e));
  return sum / double(mesh.number_of_edges());
}

// Both terms are taken relative to their means, without which `delta` would depend on the unit of
// length and on the size of the faces.
Face_distance_graph distance_graph(const Mesh& mesh, double delta)
{
  const auto angular = [&](Halfedge h) { return angular_distance(mesh, h); };
  const auto physical = [&](Halfedge h) { return centroid_distance(mesh, h); };
  const double mean_angular = mean_over_edges(mesh, angular);
  const double mean_physical = mean_over_edges(mesh, physical);
  return Face_distance_graph(mesh, [&](Halfedge h)
  {
    const double angle = mean_angular > 0 ? angular(h) / mean_angular : 0;
    return (1 - delta) * angle + delta * physical(h) / mean_physical;
  });
}

// The face of the patch with the least sum of distances within the patch to a sample of its faces.
std::size_t representative(const Face_distance_graph& graph, const Labels& labels,
                           const std::vector<std::size_t>& patch, std::size_t samples,
                           std::mt19937& random)
{
  std::vector<double> sums(patch.size(), 0.);
  for(std::size_t s = 0; s < samples; ++s)
  {
    const std::vector<double> distances =
      graph.distances_within(labels, patch[random() % patch.size()]);
    for(std::size_t i = 0; i < patch.size(); ++i)
      sums[i] += distances[patch[i]];
  }
  return patch[std::size_t(std::min_element(sums.begin(), sums.end()) - sums.begin())];
}

std::vector<std::size_t> representatives(const Face_distance_graph& graph, const Labels& labels,
                                         std::size_t number, std::size_t samples,
                                         std::mt19937& random)
{
  std::vector<std::vector<std::size_t>> patches(number);
  for(std::size_t f = 0; f < labels.size(); ++f)
    patches[labels[f]].push_back(f);
  std::vector<std::size_t> result;
  for(const std::vector<std::size_t>& patch : patches)
    result.push_back(representative(graph, labels, patch, samples, random));
  return result;
}

} // namespace

Labels k_means_segmentation(const Mesh& mesh, std::size_t number_of_segments, unsigned int seed,
                            const K_means_options& options)
{
  std::mt19937 random(seed);
  const Face_distance_graph graph = distance_graph(mesh, options.delta);
  const std::size_t number = std::min<std::size_t>(number_of_segments, mesh.number_of_faces());
  std::vector<std::size_t> seeds =
    graph.farthest_points(random() % mesh.number_of_faces(), number);
  Labels labels = graph.nearest(seeds);
  for(std::size_t i = 0; i < options.rounds; ++i)
  {
    seeds = representatives(graph, labels, number, options.samples, random);
    Labels next = graph.nearest(seeds);
    if(next == labels)
      break;
    labels = std::move(next);
  }
  return labels;
}
