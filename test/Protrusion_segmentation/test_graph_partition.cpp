// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sides of cuts on small surfaces.

#include "check.h"
#include "dual_graphs.h"
#include "node_sets.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Graph_partition;
using internal::Nodes;

void both_sides_of_a_cut_are_connected(unsigned int seed)
{
  const Seam_graph graph = seam_graph(random_surface(seed));
  const Nodes nodes = all_nodes(graph);
  Graph_partition partition(graph);
  Random random(seed);
  Nodes some;
  for (const Index i : nodes)
    if (random.index(3) == 0)
      some.push_back(i);
  if (some.empty())
    return;
  const Nodes inner = partition.connect_sides(nodes, some);
  for (const bool side : {true, false})
  {
    const auto on_side = [&](Index i) { return partition.is_inner(i) == side; };
    const auto first = std::find_if(nodes.begin(), nodes.end(), on_side);
    const std::size_t size = side ? inner.size() : nodes.size() - inner.size();
    if (first != nodes.end())
      CGAL_CHECK_EQUAL(partition.connected_nodes(*first, on_side).size(), size);
    else
      CGAL_CHECK_EQUAL(size, 0);
  }
}

// Around connected nodes the inner side keeps all of them.
void connected_nodes_stay_on_their_side(unsigned int seed)
{
  const Seam_graph graph = seam_graph(random_surface(seed));
  Graph_partition partition(graph);
  const Nodes nodes = all_nodes(graph);
  Random random(seed);
  std::vector<bool> may_be_in;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    may_be_in.push_back(random.index(4) != 0);
  Nodes connected = partition.connected_nodes(Index(random.index(nodes.size())),
                                              [&](Index i) { return may_be_in[i]; });
  std::sort(connected.begin(), connected.end());
  CGAL_CHECK(are_connected(partition, connected));
  const Nodes inner = partition.connect_sides(nodes, connected);
  CGAL_CHECK(std::includes(inner.begin(), inner.end(), connected.begin(), connected.end()));
  CGAL_CHECK(partition.marked(nodes) == inner);
}

// The arcs of a cut and the nodes along it, against all arcs.
void cuts_are_walked_along(unsigned int seed)
{
  const Seam_graph graph = seam_graph(random_surface(seed));
  Graph_partition partition(graph);
  Random random(seed);
  const internal::Segment segment = {all_nodes(graph), 1};
  Nodes inner;
  for (const Index i : segment.nodes)
    if (random.index(2) == 0)
      inner.push_back(i);
  partition.select(segment);
  partition.mark(segment.nodes, inner);
  std::set<Index> expected, found, inside, outside;
  for (const Index i : inner)
    for (const Index arc : graph.arcs(i))
      if (const Index j = graph.target[arc]; !std::binary_search(inner.begin(), inner.end(), j))
      {
        expected.insert(arc);
        inside.insert(i);
        outside.insert(j);
      }
  partition.for_each_arc_of_cut(inner, [&](Index arc, Index, Index) { found.insert(arc); });
  CGAL_CHECK(found == expected);
  const auto along = partition.nodes_along_cut(inner);
  CGAL_CHECK(std::set<Index>(along.first.begin(), along.first.end()) == inside);
  CGAL_CHECK(std::set<Index>(along.second.begin(), along.second.end()) == outside);
  CGAL_CHECK_EQUAL(along.first.size(), inside.size());
  CGAL_CHECK_EQUAL(along.second.size(), outside.size());
}

// What is selected anew has nothing marked, and nodes beside it are on no side.
void one_segment_is_selected()
{
  const Seam_graph graph = seam_graph(sheet(10, 10));
  Graph_partition partition(graph);
  const Nodes all = all_nodes(graph);
  const internal::Segment first = {{all.begin(), all.begin() + 40}, 0.4},
                          second = {{all.begin() + 30, all.end()}, 0.7};
  partition.select(first);
  partition.mark(first.nodes, {0, 1, 2});
  CGAL_CHECK(partition.is_inner(0) && partition.is_outer(39) && !partition.is_selected(40));
  CGAL_CHECK(internal::other_side(first, {0, 1, 2}) == Nodes(all.begin() + 3, all.begin() + 40));
  partition.select(second);
  CGAL_CHECK(!partition.is_selected(0) && partition.is_outer(30) && partition.marked(all).empty());
  partition.select(first);
  CGAL_CHECK(partition.marked(all).empty() && partition.is_outer(0) && !partition.is_selected(40));
}

void disjoint_nodes_beside_brute_force()
{
  Random random(7);
  for (int i = 0; i < 2000; ++i)
  {
    std::set<Index> a, b;
    for (std::size_t n = random.index(6); n > 0; --n)
      a.insert(Index(random.index(20)));
    for (std::size_t n = random.index(6); n > 0; --n)
      b.insert(Index(random.index(20)));
    const bool expected = std::none_of(a.begin(), a.end(), [&](auto x) { return b.count(x) > 0; });
    CGAL_CHECK_EQUAL(internal::are_disjoint(Nodes(a.begin(), a.end()), Nodes(b.begin(), b.end())), expected);
  }
}

int main()
{
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    both_sides_of_a_cut_are_connected(seed);
    connected_nodes_stay_on_their_side(seed);
    cuts_are_walked_along(seed);
  }
  one_segment_is_selected();
  disjoint_nodes_beside_brute_force();
  return check::result();
}
