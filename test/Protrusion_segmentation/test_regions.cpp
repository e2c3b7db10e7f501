// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connected regions with cheap borders, against brute force on small surfaces and on a body whose regions are known.

#include "check.h"
#include "dual_graphs.h"
#include "node_sets.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Candidates/regions.h>

#include <set>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Graph_partition;
using internal::Merged_regions;
using internal::Nodes;
using internal::Region;

Merged_regions regions_of(const Seam_graph& graph, const Nodes& nodes)
{
  Graph_partition partition(graph);
  const internal::Segment segment = {nodes, graph.area_of(nodes)};
  partition.select(segment);
  Merged_regions result = internal::Region_merger(graph)(partition, segment);
  Nodes sorted = result.order;
  std::sort(sorted.begin(), sorted.end());
  CGAL_CHECK(sorted == nodes);
  return result;
}

Node_set nodes_of(const Merged_regions& merged, const Region& region)
{
  const auto first = merged.order.begin() + region.first;
  return Node_set(first, first + region.number_of_nodes);
}

// what lies between two sets of nodes, or around one in its segment
double cost_between(const Seam_graph& graph, const Node_set& a, const Node_set& b)
{
  double cost = 0;
  for (const Index i : a)
    for (const Index arc : graph.arcs(i))
      if (b.count(graph.target[arc]) > 0 && a.count(graph.target[arc]) == 0)
        cost += graph.capacity[arc];
  return cost;
}

// All clusters while the two of the largest affinity for their size are merged, found by trying all.
std::set<Node_set> clusters_by_brute_force(const Seam_graph& graph, const Node_set& segment)
{
  std::vector<Node_set> clusters;
  for (const Index i : segment)
    clusters.push_back({i});
  std::set<Node_set> result(clusters.begin(), clusters.end());
  while (clusters.size() > 1)
  {
    double strongest = -1;
    std::size_t a = 0, b = 0;
    for (std::size_t i = 0; i < clusters.size(); ++i)
      for (std::size_t j = i + 1; j < clusters.size(); ++j)
      {
        const double cost = cost_between(graph, clusters[i], clusters[j]);
        const double area = (std::min)(area_of(graph, clusters[i]), area_of(graph, clusters[j]));
        if (cost > 0 && cost / std::pow(area, 0.75) > strongest)
        {
          strongest = cost / std::pow(area, 0.75);
          a = i;
          b = j;
        }
      }
    if (strongest < 0)
      break;
    clusters[a].insert(clusters[b].begin(), clusters[b].end());
    clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(b));
    result.insert(clusters[a]);
  }
  return result;
}

void regions_are_the_best_clusters(const Seam_graph& graph, const Nodes& segment)
{
  const Merged_regions merged = regions_of(graph, segment);
  const Node_set nodes(merged.order.begin(), merged.order.end());
  const std::set<Node_set> clusters = clusters_by_brute_force(graph, nodes);
  const double segment_area = area_of(graph, nodes);
  const auto cost = [&](const Node_set& set)
  {
    const double area = area_of(graph, set), smaller = (std::min)(area, segment_area - area);
    return internal::is_large_enough(area, segment_area)
             ? internal::cost_for_area(cost_between(graph, set, nodes), smaller)
             : infinity;
  };
  double best = infinity, before = 0;
  for (const Node_set& cluster : clusters)
    if (cluster.size() > 1)
      best = (std::min)(best, cost(cluster));
  for (const Region& region : merged.regions)
  {
    const Node_set set = nodes_of(merged, region);
    CGAL_CHECK_EQUAL(clusters.count(set), 1u);
    CGAL_CHECK_CLOSE(region.relative_cost, cost(set), 1e-9 * (1 + region.relative_cost));
    CGAL_CHECK(region.relative_cost >= before);
    before = region.relative_cost;
  }
  CGAL_CHECK_EQUAL(merged.regions.empty(), best == infinity);
  if (!merged.regions.empty())
    CGAL_CHECK_CLOSE(merged.regions.front().relative_cost, best, 1e-9 * (1 + best));
}

void random_surfaces(unsigned int seed)
{
  const Seam_graph graph = seam_graph(random_surface(seed));
  regions_are_the_best_clusters(graph, all_nodes(graph));
  Nodes part; // that need not be connected
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    if ((i / 7 + seed) % 2 == 0)
      part.push_back(i);
  regions_are_the_best_clusters(graph, part);
}

// A fish: a long body with a fin on its back that is as long as half of it, low and thin. A level set of the distance from
// any tip is round; the fin is not.
void a_low_fin_is_a_region()
{
  Cubes cubes;
  add_cubes(cubes, {0, 0, 0}, {24, 7, 7});
  add_cubes(cubes, {6, 3, 7}, {18, 4, 10});
  const Indexed_surface surface = to_surface(triangulated(voxels(cubes)));
  const Seam_graph graph = seam_graph(surface);
  const Merged_regions merged = regions_of(graph, all_nodes(graph));
  const auto is_of_fin = [&](Index face) { return surface.centroid(face).z() > 7; };
  Node_set fin;
  for (const Index i : merged.order)
    if (is_of_fin(i))
      fin.insert(i);
  double best = 0; // overlap
  for (const Region& region : merged.regions)
  {
    const Node_set set = nodes_of(merged, region);
    const double common = static_cast<double>(std::count_if(set.begin(), set.end(), is_of_fin));
    best = (std::max)(
      best, common / static_cast<double>(set.size() + fin.size() - static_cast<std::size_t>(common)));
  }
  CGAL_CHECK(best > 0.95);
}

// Areas and affinities of zero.
void collapsed_faces()
{
  Test_mesh mesh = star(4);
  for (std::size_t p = 0; p < mesh.points.size(); p += 16)
    mesh.points[p] = mesh.points.front();
  const Seam_graph graph = seam_graph(mesh);
  for (const Region& region : regions_of(graph, all_nodes(graph)).regions)
    CGAL_CHECK(region.relative_cost >= 0 && region.relative_cost < infinity);
}

int main()
{
  for (unsigned int seed = 0; seed < 15; ++seed)
    random_surfaces(seed);
  a_low_fin_is_a_region();
  collapsed_faces();
  return check::result();
}
