// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Minimum cuts against brute force on small surfaces.

#include "check.h"
#include "costs_of_cuts.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/minimum_cut.h>

#include <algorithm>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Graph_partition;
using internal::Nodes;

// Over all subsets of the band.
void minimum_cuts_are_minimal(unsigned int seed)
{
  const Seam_graph graph = seam_graph(random_surface(seed));
  const Index n = graph.number_of_nodes();
  Graph_partition partition(graph);
  const Nodes order = internal::Graph_distances(graph)(
                        Nodes(1, 0), [](Index, Index) { return true; }, graph.lengths())
                        .nodes;
  const Index half = n / 2;
  if (half < 6 || half + 6 > n)
    return;
  const Nodes inner(order.begin(), order.begin() + half);
  const Nodes band(order.begin() + half - 5, order.begin() + half + 5);
  partition.mark(order, inner);
  std::vector<bool> is_inner(n, false);
  for (const Index i : inner)
    is_inner[i] = true;

  std::vector<Index> number(n, Indexed_surface::no_face());
  internal::Band_network network(partition, band, number);
  CGAL_CHECK(
    std::all_of(number.begin(), number.end(), [](Index i) { return i == Indexed_surface::no_face(); }));
  if (!network.has_terminals())
    return;
  const std::vector<bool> source_side = network.source_side();
  std::vector<bool> found = is_inner;
  for (std::size_t i = 0; i < band.size(); ++i)
    found[band[i]] = source_side[i];

  double least = infinity;
  for (unsigned int subset = 0; subset < (1u << band.size()); ++subset)
  {
    std::vector<bool> candidate = is_inner;
    for (std::size_t i = 0; i < band.size(); ++i)
      candidate[band[i]] = (subset >> i) & 1;
    least = (std::min)(least, cost_of(graph, candidate));
  }
  CGAL_CHECK_CLOSE(cost_of(graph, found), least, 1e-6 * (1 + least));
}

// The minimum cut in the band around a cut is no dearer, and moves nodes near the cut only.
void moved_nodes_make_cuts_cheaper(unsigned int seed)
{
  const Seam_graph graph = seam_graph(random_surface(seed));
  Graph_partition partition(graph);
  internal::Graph_distances distances(graph);
  internal::Minimum_cut minimum_cut(partition, distances);
  const Nodes order = distances(
                        Nodes(1, 0), [](Index, Index) { return true; }, graph.lengths())
                        .nodes;
  for (const double share : {0.1, 0.3, 0.5})
  {
    Nodes inner(order.begin(), order.begin() + std::ptrdiff_t(1 + share * double(order.size() - 1)));
    std::sort(inner.begin(), inner.end());
    partition.mark(order, inner);
    std::vector<bool> is_inner(graph.number_of_nodes(), false);
    for (const Index i : inner)
      is_inner[i] = true;
    const double before = cost_of(graph, is_inner);
    const Nodes moved = minimum_cut.nodes_to_move(inner, {0.35, 1.4, 0.7});
    CGAL_CHECK(std::is_sorted(moved.begin(), moved.end()));
    for (const Index i : moved)
      is_inner[i] = !is_inner[i];
    CGAL_CHECK(cost_of(graph, is_inner) <= before * (1 + 1e-6));
  }
}

int main()
{
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    minimum_cuts_are_minimal(seed);
    moved_nodes_make_cuts_cheaper(seed);
  }
  return check::result();
}
