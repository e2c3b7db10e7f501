// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The best level sets against brute force on small surfaces.

#include "check.h"
#include "costs_of_cuts.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Candidates/level_sets.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>

#include <algorithm>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Nodes;

// The least relative cost among the components of all sublevel sets of an order, one by one.
double best_component(const Seam_graph& graph, const Nodes& order)
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
    if (queue.size() < order.size() && internal::is_large_enough(area, 1))
      best = (std::min)(best, internal::cost_for_area(cost_of(graph, inner), (std::min)(area, 1 - area)));
  }
  return best;
}

void sweeps_find_the_best_level_set(const Test_mesh& mesh, Index tip)
{
  const Seam_graph graph = seam_graph(mesh);
  Nodes order = internal::Graph_distances(graph)(
                  Nodes(1, tip % graph.number_of_nodes()), [](Index, Index) { return true; },
                  graph.seam_lengths())
                  .nodes;
  CGAL_CHECK_EQUAL(order.size(), graph.number_of_nodes());
  const internal::Graph_partition partition(graph);
  internal::Level_set_sweep sweep(graph);
  for (int direction = 0; direction < 2; ++direction)
  {
    double best = infinity;
    for (const internal::Level_set& level_set : sweep(partition, order, 1))
      best = (std::min)(best, level_set.relative_cost);
    const double expected = best_component(graph, order);
    if (expected < infinity)
      CGAL_CHECK_CLOSE(best, expected, 1e-6 * (1 + expected));
    std::reverse(order.begin(), order.end());
  }
}

int main()
{
  for (unsigned int seed = 0; seed < 60; ++seed)
    sweeps_find_the_best_level_set(random_surface(seed), seed);
  // faces much smaller than the least area of a segment: a branch that grows to the whole keeps its best
  sweeps_find_the_best_level_set(capsule_with_ball(), 0);
  return check::result();
}
