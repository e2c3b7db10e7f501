// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connectivity of a side of a cut, found near the nodes that have changed sides, against a walk over all of it.

#include "check.h"
#include "dual_graphs.h"
#include "node_sets.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Local_connectivity.h>

#include <algorithm>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Graph_partition;
using internal::Nodes;

// The nodes on one side.
Nodes side(const Graph_partition& partition, bool inner)
{
  Nodes result;
  for (Index i = 0; i < partition.graph().number_of_nodes(); ++i)
    if (partition.is_inner(i) == inner)
      result.push_back(i);
  return result;
}

// All nodes of a graph, the nearest to `seed` first.
Nodes nearest_first(const Seam_graph& graph, Index seed)
{
  return internal::Graph_distances(graph)(
           {seed}, [](Index, Index) { return true; }, graph.lengths())
    .nodes;
}

// The `size` nodes that are nearest to `seed`, a disc, are the inner side.
void mark_disc(Graph_partition& partition, Index seed, std::size_t size)
{
  const Nodes order = nearest_first(partition.graph(), seed);
  for (std::size_t k = 0; k < order.size(); ++k)
    partition.set_inner(order[k], k < size);
}

void agrees_with_a_walk_over_all(const Test_mesh& mesh)
{
  const Seam_graph graph = seam_graph(mesh);
  const Index n = graph.number_of_nodes();
  Random random(n);
  Graph_partition partition(graph);
  internal::Local_connectivity connectivity(partition);
  std::size_t connected = 0, seen = 0;
  for (int i = 0; i < 400; ++i)
  {
    mark_disc(partition, Index(random.index(n)), 1 + random.index(n - 1));
    if (!are_connected(partition, side(partition, false)))
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
      const bool is_connected = !nodes.empty() && are_connected(partition, nodes);
      const bool is_seen = connectivity.is_connected(inner, changed);
      CGAL_CHECK(is_connected || !is_seen);
      connected += is_connected;
      seen += is_seen;
    }
  }
  CGAL_CHECK(n < 500 || connected > 50);
  CGAL_CHECK(2 * seen >= connected); // else it is of no use
}

// A disc may leave a torus; a face of it that comes back alone is seen to be no part of the rest.
void an_island_is_not_connected()
{
  const Seam_graph graph = seam_graph(torus());
  Graph_partition partition(graph);
  internal::Local_connectivity connectivity(partition);
  const Nodes order = nearest_first(graph, 0);
  const std::size_t size = order.size() / 10;
  for (std::size_t k = 0; k < size; ++k)
    partition.set_inner(order[k], true);
  CGAL_CHECK(connectivity.is_connected(false, {order.begin(), order.begin() + std::ptrdiff_t(size)}));
  partition.set_inner(0, false);
  CGAL_CHECK(!connectivity.is_connected(false, {0}));
  CGAL_CHECK(connectivity.is_connected(true, {0}));
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
