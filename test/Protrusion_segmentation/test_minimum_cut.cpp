// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Level sets and minimum cuts against brute force on small surfaces.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"
#include "weighted_dual_graphs.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Tip_orders.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/measure_volumes.h>

#include <numeric>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Graph_partition;
using internal::Level_set;
using internal::Weighted_dual_graph;
using Nodes = Graph_partition::Nodes;

Nodes all_nodes(const Weighted_dual_graph& graph)
{
  Nodes nodes(graph.number_of_nodes());
  std::iota(nodes.begin(), nodes.end(), Index(0));
  return nodes;
}

double cost_of(const Weighted_dual_graph& graph, const std::vector<bool>& inner)
{
  double cost = 0;
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    for (const Index arc : graph.arcs(i))
      if (inner[i] && !inner[graph.target[arc]])
        cost += graph.capacity[arc];
  return cost;
}

// The least relative cost among the components of all sublevel sets of an order, one by one.
double best_component(const Weighted_dual_graph& graph, const Nodes& order)
{
  double best = infinity;
  std::vector<bool> is_below(graph.number_of_nodes(), false);
  for (const Index last : order)
  {
    is_below[last] = true;
    std::vector<bool> inner(graph.number_of_nodes(), false);
    std::vector<Index> queue(1, last);
    inner[last] = true;
    double area = 0;
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      area += graph.area[queue[i]];
      for (const Index arc : graph.arcs(queue[i]))
        if (is_below[graph.target[arc]] && !inner[graph.target[arc]])
        {
          inner[graph.target[arc]] = true;
          queue.push_back(graph.target[arc]);
        }
    }
    if (queue.size() < order.size())
      best = (std::min)(best, internal::relative_cost(cost_of(graph, inner), area, 1));
  }
  return best;
}

void sweeps_find_the_best_level_set(const Test_mesh& mesh, Index tip)
{
  const Weighted_dual_graph graph = weighted_dual_graph(to_surface(mesh));
  Graph_partition partition(graph, std::vector<Index>(graph.number_of_nodes(), 0));
  Nodes order = partition
                  .nodes_by_distance(
                    Nodes(1, tip % graph.number_of_nodes()), [](Index) { return true; },
                    graph.seam_lengths())
                  .nodes;
  CHECK_EQUAL(order.size(), graph.number_of_nodes());
  internal::Level_set_sweep sweep(partition);
  for (const bool descending : {false, true})
  {
    std::vector<Level_set> level_sets;
    sweep(order, 1, 0, descending, level_sets);
    double best = infinity;
    for (const Level_set& level_set : level_sets)
      best = (std::min)(best, level_set.relative_cost);
    const double expected = best_component(graph, order);
    if (expected < infinity)
      CHECK_CLOSE(best, expected, 1e-6 * (1 + expected));
    std::reverse(order.begin(), order.end());
  }
}

// Over all subsets of the band.
void minimum_cuts_are_minimal(unsigned int seed)
{
  const Weighted_dual_graph graph = weighted_dual_graph(to_surface(random_surface(seed)));
  const Index n = graph.number_of_nodes();
  Graph_partition partition(graph, std::vector<Index>(n, 0));
  const Nodes order = partition
                        .nodes_by_distance(
                          Nodes(1, 0), [](Index) { return true; }, graph.lengths())
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
  internal::Band_network network(partition, 0, band, number);
  CHECK(
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
  CHECK_CLOSE(cost_of(graph, found), least, 1e-6 * (1 + least));
}

void both_sides_of_a_cut_are_connected(unsigned int seed)
{
  const Weighted_dual_graph graph = weighted_dual_graph(to_surface(random_surface(seed)));
  const Nodes nodes = all_nodes(graph);
  Graph_partition partition(graph, std::vector<Index>(nodes.size(), 0));
  Random random(seed);
  Nodes some;
  for (const Index i : nodes)
    if (random.index(3) == 0)
      some.push_back(i);
  if (some.empty())
    return;
  const Nodes inner = partition.connect_sides(nodes, 0, some);
  for (const bool side : {true, false})
  {
    const auto on_side = [&](Index i) { return partition.is_inner(i) == side; };
    const auto first = std::find_if(nodes.begin(), nodes.end(), on_side);
    const std::size_t size = side ? inner.size() : nodes.size() - inner.size();
    if (first != nodes.end())
      CHECK_EQUAL(partition.connected_nodes(*first, on_side).size(), size);
    else
      CHECK_EQUAL(size, 0);
  }
}

// Around connected nodes the cheaper way gives the same sides as the one for any nodes.
void connected_nodes_keep_their_side(unsigned int seed)
{
  const Weighted_dual_graph graph = weighted_dual_graph(to_surface(random_surface(seed)));
  Graph_partition partition(graph, std::vector<Index>(graph.number_of_nodes(), 1));
  Nodes nodes = partition.connected_nodes(0, [](Index) { return true; });
  std::sort(nodes.begin(), nodes.end());
  for (const Index i : nodes)
    partition.set_segment(i, 0);
  Random random(seed);
  std::vector<bool> may_be_in(graph.number_of_nodes(), false);
  for (const Index i : nodes)
    may_be_in[i] = random.index(4) != 0;
  const Nodes connected = partition.connected_nodes(nodes[random.index(nodes.size())], [&](Index i) { return may_be_in[i]; });
  Nodes others;
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(others), [&](Index i)
               { return std::find(connected.begin(), connected.end(), i) == connected.end(); });
  CHECK(partition.connect_other_side(nodes, 0, connected, false) == partition.connect_sides(nodes, 0, connected));
  CHECK(partition.connect_other_side(nodes, 0, connected, true) == partition.connect_sides(nodes, 0, others));
}

// The best cuts of a star are its arms.
void best_cuts_of_a_star_are_its_arms()
{
  const Test_mesh mesh = star(6);
  const Indexed_surface surface = to_surface(mesh);
  Weighted_dual_graph graph = weighted_dual_graph(surface);
  const Nodes nodes = all_nodes(graph);
  internal::measure_volumes(surface, nodes, graph); // every face is a node
  Graph_partition partition(graph, std::vector<Index>(nodes.size(), 0));
  internal::Cut_search search(partition, internal::default_cut_policy(), quiet_execution());
  internal::Tip_orders tip_orders(partition, quiet_execution());
  internal::Cut_search::Candidate_sources sources;
  tip_orders.from_all_tips(0, nodes, [&](Nodes order) { sources.add_order(std::move(order)); });
  const std::vector<internal::Cut> cuts = search.cuts(0, nodes, std::move(sources));
  // more than one, but not always all: the others are found in what remains
  constexpr std::size_t least_number = 3;
  CHECK(cuts.size() >= least_number);
  for (std::size_t c = 0; c < least_number && c < cuts.size(); ++c)
  {
    CHECK(cuts[c].value > 0);
    CHECK(c == 0 || cuts[c].value <= cuts[c - 1].value);
    std::vector<double> area(7, 0);
    for (const Index i : cuts[c].inner)
      area[mesh.parts[i]] += graph.area[i];
    const double total = std::accumulate(area.begin(), area.end(), 0.);
    CHECK(*std::max_element(area.begin() + 1, area.end()) > 0.9 * total);
  }
}

int main()
{
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    sweeps_find_the_best_level_set(random_surface(seed), seed);
    minimum_cuts_are_minimal(seed);
    both_sides_of_a_cut_are_connected(seed);
    connected_nodes_keep_their_side(seed);
  }
  // faces much smaller than the least area of a part: a branch that grows to the whole keeps its best
  sweeps_find_the_best_level_set(capsule_with_ball(), 0);
  best_cuts_of_a_star_are_its_arms();
  return check::result();
}
