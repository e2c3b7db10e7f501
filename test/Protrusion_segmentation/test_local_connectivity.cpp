// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is found out about a side of a cut near the nodes that have changed sides, against a walk over all of it.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"
#include "weighted_dual_graphs.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Local_connectivity.h>

#include <algorithm>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Graph_partition;
using Nodes = Graph_partition::Nodes;

// The nodes on one side.
Nodes side(const Graph_partition& partition, bool inner)
{
  Nodes result;
  for (Index i = 0; i < partition.graph().number_of_nodes(); ++i)
    if (partition.is_inner(i) == inner)
      result.push_back(i);
  return result;
}

// The nodes of the segment that is nearest to `seed`, a disc, are its inner side.
void mark_disc(Graph_partition& partition, Index seed, std::size_t size)
{
  const auto order = partition.nodes_by_distance({seed}, [](Index) { return true; }, partition.graph().lengths());
  for (std::size_t k = 0; k < order.nodes.size(); ++k)
    partition.set_inner(order.nodes[k], k < size);
}

void agrees_with_a_walk_over_all(const Test_mesh& mesh)
{
  const auto graph = weighted_dual_graph(mesh);
  const Index n = graph.number_of_nodes();
  Random random(n);
  Graph_partition partition(graph, std::vector<Index>(n, 0));
  internal::Local_connectivity connectivity(partition);
  std::size_t connected = 0, seen = 0;
  for (int i = 0; i < 400; ++i)
  {
    mark_disc(partition, Index(random.index(n)), 1 + random.index(n - 1));
    if (!partition.are_connected(side(partition, false)))
      continue; // was not connected before
    Nodes changed;
    const std::size_t number = 1 + random.index(i % 2 == 0 ? 4 : n / 3);
    const Index first = Index(random.index(n));
    for (Index k = 0; k < number; ++k) // all over the surface, or side by side
      changed.push_back(i % 4 < 2 ? Index(random.index(n)) : (first + k) % n);
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const Index node : changed)
      partition.set_inner(node, !partition.is_inner(node));
    for (const bool inner : {true, false})
    {
      const Nodes nodes = side(partition, inner);
      const bool is_connected = !nodes.empty() && partition.are_connected(nodes);
      const bool is_seen = connectivity.is_connected(0, inner, changed);
      CHECK(is_connected || !is_seen);
      connected += is_connected;
      seen += is_seen;
    }
  }
  CHECK(n < 500 || connected > 50);
  CHECK(2 * seen >= connected); // else it is of no use
}

// A disc may leave a torus; a face of it that comes back alone is seen to be no part of the rest.
void an_island_is_not_connected()
{
  const auto graph = weighted_dual_graph(torus());
  Graph_partition partition(graph, std::vector<Index>(graph.number_of_nodes(), 0));
  internal::Local_connectivity connectivity(partition);
  const auto order = partition.nodes_by_distance({0}, [](Index) { return true; }, graph.lengths());
  const std::size_t size = order.nodes.size() / 10;
  for (std::size_t k = 0; k < size; ++k)
    partition.set_inner(order.nodes[k], true);
  CHECK(connectivity.is_connected(0, false, {order.nodes.begin(), order.nodes.begin() + std::ptrdiff_t(size)}));
  partition.set_inner(0, false);
  CHECK(!connectivity.is_connected(0, false, {0}));
  CHECK(connectivity.is_connected(0, true, {0}));
}

int main()
{
  agrees_with_a_walk_over_all(capsule_with_ball());
  agrees_with_a_walk_over_all(icosphere(3));
  agrees_with_a_walk_over_all(torus());
  for (std::uint_fast32_t seed = 0; seed < 10; ++seed)
    agrees_with_a_walk_over_all(random_surface(seed));
  an_island_is_not_connected();
  return check::result();
}
