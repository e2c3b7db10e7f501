// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes by their distances from others, against the definition: ways that get shorter until none does.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"
#include "weighted_dual_graphs.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Graph_partition;
using internal::Weighted_dual_graph;
using Nodes = Graph_partition::Nodes;

// The nodes up to a limit that can be reached over nodes of segment 0, the nearest first, equally near ones by number.
std::vector<std::pair<float, Index>> expected_order(const Graph_partition& partition, const Nodes& seeds, double limit)
{
  const Weighted_dual_graph& graph = partition.graph();
  std::vector<float> distances(graph.number_of_nodes(), std::numeric_limits<float>::infinity());
  for (Index seed : seeds)
    distances[seed] = 0;
  for (bool has_changed = true; has_changed;)
  {
    has_changed = false;
    for (Index i = 0; i < graph.number_of_nodes(); ++i)
      for (Index arc : graph.arcs(i))
        if (const float distance = distances[i] + graph.length[arc];
            partition.segment(graph.target[arc]) == 0 && distance < distances[graph.target[arc]])
        {
          distances[graph.target[arc]] = distance;
          has_changed = true;
        }
  }
  std::vector<std::pair<float, Index>> result;
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    if (distances[i] < std::numeric_limits<float>::infinity() && distances[i] <= limit)
      result.emplace_back(distances[i], i);
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::pair<float, Index>> found_order(Graph_partition& partition, const Nodes& seeds, double limit)
{
  const internal::Nodes_by_distance found = partition.nodes_by_distance(
    seeds, [&](Index i) { return partition.segment(i) == 0; }, partition.graph().lengths(), limit);
  std::vector<std::pair<float, Index>> result;
  for (std::size_t k = 0; k < found.nodes.size(); ++k)
    result.emplace_back(static_cast<float>(found.distances[k]), found.nodes[k]);
  return result;
}

// From one node or two of them, up to any limit; nothing is left behind for the next search.
void is_as_defined(const Weighted_dual_graph& graph, std::uint_fast32_t seed)
{
  Random random(seed);
  const Index n = graph.number_of_nodes();
  std::vector<Index> segments(n, 0);
  for (Index& segment : segments)
    segment = random.index(5) == 0 ? 1 : 0;
  Graph_partition partition(graph, segments);
  for (int i = 0; i < 6; ++i)
  {
    Nodes seeds(1, Index(random.index(n)));
    if (i % 2 == 1)
      seeds.push_back(Index((seeds[0] + 1 + random.index(n - 1)) % n));
    const auto all = expected_order(partition, seeds, std::numeric_limits<double>::infinity());
    for (const double limit : {0., double(all[all.size() / 2].first), double(all.back().first) / 3, 1e30})
      CHECK(found_order(partition, seeds, limit) == expected_order(partition, seeds, limit));
    const auto farthest = partition.farthest_node(
      seeds, [&](Index node) { return partition.segment(node) == 0; }, graph.lengths());
    CHECK_EQUAL(farthest.first, all.back().second);
    CHECK_EQUAL(farthest.second, all.back().first);
  }
}

// Lengths of all kinds: all the same, so that many nodes are equally near, any, and some that are a million times the mean.
void is_as_defined_for_all_lengths()
{
  for (std::uint_fast32_t seed = 0; seed < 30; ++seed)
  {
    Weighted_dual_graph graph = weighted_dual_graph(random_surface(seed));
    is_as_defined(graph, seed);
    Random random(seed);
    for (Index i = 0; i < graph.number_of_nodes(); ++i)
      for (Index arc : graph.arcs(i))
        graph.length[arc] = seed % 3 == 0 ? 1.f : float(random.real(0.1, 1)) * (random.index(50) == 0 ? 1e6f : 1.f);
    is_as_defined(graph, seed + 1000);
  }
}

int main()
{
  is_as_defined_for_all_lengths();
  return check::result();
}
