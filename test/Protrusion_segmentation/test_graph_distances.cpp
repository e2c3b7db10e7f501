// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes by their distances from others, against the definition: paths that get shorter until none does.

#include "check.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Nodes;

// The nodes up to a limit that can be reached over open nodes, the nearest first, equally near ones by number.
std::vector<std::pair<float, Index>> expected_order(const Seam_graph& graph,
                                                    const std::vector<bool>& is_open,
                                                    const Nodes& seeds,
                                                    double limit)
{
  std::vector<float> distances(graph.number_of_nodes(), std::numeric_limits<float>::infinity());
  for (Index seed : seeds)
    distances[seed] = 0;
  for (bool has_changed = true; has_changed;)
  {
    has_changed = false;
    for (Index i = 0; i < graph.number_of_nodes(); ++i)
      for (Index arc : graph.arcs(i))
        if (const float distance = distances[i] + graph.length[arc];
            is_open[graph.target[arc]] && distance < distances[graph.target[arc]])
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

std::vector<std::pair<float, Index>> as_pairs(const internal::Nodes_by_distance& found)
{
  std::vector<std::pair<float, Index>> result;
  for (std::size_t k = 0; k < found.nodes.size(); ++k)
    result.emplace_back(static_cast<float>(found.distances[k]), found.nodes[k]);
  return result;
}

// From one node or two of them, up to any limit; no search leaves anything behind for the next one.
void is_as_defined(const Seam_graph& graph, std::uint_fast32_t seed)
{
  Random random(seed);
  const Index n = graph.number_of_nodes();
  std::vector<bool> is_open;
  for (Index i = 0; i < n; ++i)
    is_open.push_back(random.index(5) != 0);
  internal::Graph_distances distances(graph);
  const auto found = [&](const Nodes& seeds, double limit)
  {
    const auto is_inside = [&](Index, Index to) -> bool { return is_open[to]; };
    auto in_any_order = as_pairs(distances.in_any_order(seeds, is_inside, graph.lengths(), limit));
    std::sort(in_any_order.begin(), in_any_order.end());
    const auto result = as_pairs(distances(seeds, is_inside, graph.lengths(), limit));
    CGAL_CHECK(in_any_order == result);
    return result;
  };
  for (int i = 0; i < 6; ++i)
  {
    Nodes seeds(1, Index(random.index(n)));
    if (i % 2 == 1)
      seeds.push_back(Index((seeds[0] + 1 + random.index(n - 1)) % n));
    const auto all = expected_order(graph, is_open, seeds, infinity);
    CGAL_CHECK(found(seeds, infinity) == all);
    for (const double limit : {0., double(all[all.size() / 2].first), double(all.back().first) / 3, 1e30})
      CGAL_CHECK(found(seeds, limit) == expected_order(graph, is_open, seeds, limit));
  }
}

// A condition on both ends of an arc: paths that do not leave the set of nodes that they begin in.
void paths_may_stay_in_a_set(std::uint_fast32_t seed)
{
  const Seam_graph graph = seam_graph(random_surface(seed));
  Random random(seed);
  std::vector<Index> set_of_node;
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    set_of_node.push_back(Index(random.index(2)));
  Nodes seeds = {0};
  while (seeds.size() < 2)
    if (const Index i = Index(random.index(graph.number_of_nodes())); set_of_node[i] != set_of_node[0])
      seeds.push_back(i);
  const auto found = as_pairs(internal::Graph_distances(graph)(
    seeds, [&](Index from, Index to) { return set_of_node[from] == set_of_node[to]; }, graph.lengths()));
  std::vector<std::pair<float, Index>> expected;
  for (const Index s : seeds)
  {
    std::vector<bool> is_open;
    for (const Index set : set_of_node)
      is_open.push_back(set == set_of_node[s]);
    const auto of_set = expected_order(graph, is_open, {s}, infinity);
    expected.insert(expected.end(), of_set.begin(), of_set.end());
  }
  std::sort(expected.begin(), expected.end());
  CGAL_CHECK(found == expected);
}

// Lengths of all kinds: all the same, so that many nodes are equally near, any, and some that are a million times the mean.
void is_as_defined_for_all_lengths()
{
  for (std::uint_fast32_t seed = 0; seed < 30; ++seed)
  {
    Seam_graph graph = seam_graph(random_surface(seed));
    is_as_defined(graph, seed);
    Random random(seed);
    for (Index i = 0; i < graph.number_of_nodes(); ++i)
      for (Index arc : graph.arcs(i))
        graph.length[arc] = seed % 3 == 0
                              ? 1.f
                              : float(random.real(0.1, 1)) * (random.index(50) == 0 ? 1e6f : 1.f);
    is_as_defined(graph, seed + 1000);
  }
}

int main()
{
  is_as_defined_for_all_lengths();
  for (std::uint_fast32_t seed = 0; seed < 20; ++seed)
    paths_may_stay_in_a_set(seed);
  return check::result();
}
