// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_SEGMENT_SEARCH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_SEGMENT_SEARCH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Candidates/candidates.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Candidates/distance_orders.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Candidates/level_sets.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Candidates/regions.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Candidates/tip_orders.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Thread_workspaces.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The work arrays of one thread that searches for cuts.
struct Search_workspace
{
  Graph_partition partition;
  Graph_distances distances;
  Tip_orders tip_orders;
  Level_set_sweep sweep;
  Region_merger merge_regions;
  Candidate_chooser choose;
  Cutter cutter;

  Search_workspace(const Volume_graph& graph, const Cut_options& options)
    : partition(graph),
      distances(graph),
      tip_orders(graph, partition, distances),
      sweep(graph),
      merge_regions(graph),
      choose(graph, options),
      cutter(graph, options, partition, distances),
      m_graph(graph),
      m_options(options)
  {}
  Search_workspace(const Search_workspace& other) : Search_workspace(other.m_graph, other.m_options) {}
  Search_workspace& operator=(const Search_workspace&) = delete;

private:
  const Volume_graph& m_graph;
  const Cut_options& m_options;
};

// Searches a segment for its best cuts, step by step: orders of its nodes by the distance from tips, level sets of
// these and regions, candidates, and minimum cuts near these. Several threads share the work of a step.
class Segment_search
{
public:
  using Index = Dual_graph::Index;

  // The arguments must outlive the object. Without a distance, orders are those of the coarse graph.
  Segment_search(const Indexed_surface& surface,
                 const Graphs_of_surface& graphs,
                 const std::optional<Any_distance>& distance,
                 const Cut_options& options,
                 Execution& execution)
    : m_surface(surface),
      m_graphs(graphs),
      m_distance(distance),
      m_execution(execution),
      m_workspaces(graphs.coarse, options)
  {}

  std::size_t number_of_runs() const { return m_number_of_runs; }
  // Calls `visit(workspace)` for that of every thread: they count what they do.
  template <typename Visit>
  void for_each_workspace(Visit visit) const
  {
    m_workspaces.for_each(visit);
  }

  // The cuts of a segment, best first.
  std::vector<Cut> operator()(const Segment& segment)
  {
    return best_cuts(segment, find_orders(segment), [](const Nodes&) { return true; });
  }

  // The best cut around a level set or region for which `accept(nodes)` holds, level sets around `tip` among them; it has
  // the tip on its inner side, for which `accept` holds as well.
  template <typename Accept>
  std::optional<Cut> cut_of_tip(const Segment& segment, Index tip, Accept accept)
  {
    Orders orders = find_orders(segment);
    add_order(orders, from_tip(segment, tip).nodes);
    std::optional<Cut> best;
    for (Cut& cut : best_cuts(segment, std::move(orders), accept))
    {
      if (!std::binary_search(cut.inner.begin(), cut.inner.end(), tip))
        cut.inner = other_side(segment, cut.inner);
      if (accept(cut.inner) && (!best || cut.value > best->value))
        best = std::move(cut);
    }
    return best;
  }

  // The cut around given nodes of a segment.
  std::optional<Cut> cut_around(const Segment& segment, const Nodes& nodes)
  {
    return m_workspaces.own().cutter.cut_around(segment, nodes);
  }

  Nodes_by_distance from_tip(const Segment& segment, Index tip)
  {
    ++m_number_of_runs;
    return m_workspaces.own().tip_orders.from_tip(segment, tip);
  }

private:
  using Orders = std::vector<Ordered_level_sets>;

  // Calls `body(workspace, i)` for all i below `number`.
  template <typename Body>
  void for_each(std::size_t number, Body body)
  {
    m_workspaces.for_each_index(number, m_execution.is_parallel(),
                                [&](Search_workspace& workspace, std::size_t i)
                                {
                                  m_execution.check();
                                  body(workspace, i);
                                });
  }

  static void add_order(Orders& orders, Nodes order)
  {
    Nodes reverse(order.rbegin(), order.rend());
    orders.push_back({std::move(order), {}});
    orders.push_back({std::move(reverse), {}});
  }

  // The orders of the nodes, from near and from far. A distance of the user's may use several threads itself.
  Orders find_orders(const Segment& segment)
  {
    const Stage_scope stage(m_execution.observer(), Stage::TIPS);
    m_execution.check();
    std::vector<Nodes> from_near =
      m_distance ? distance_orders(m_surface, segment.nodes, m_graphs.node_of_face, *m_distance, m_execution)
                 : m_workspaces.own().tip_orders(segment, m_execution);
    m_number_of_runs += m_distance ? 0 : from_near.size() + 1; // and one from the centre
    Orders result;
    for (Nodes& order : from_near)
      add_order(result, std::move(order));
    return result;
  }

  // The cuts around the best candidates that are accepted.
  template <typename Accept>
  std::vector<Cut> best_cuts(const Segment& segment, Orders orders, Accept accept)
  {
    const Stage_scope stage(m_execution.observer(), Stage::BORDERS);
    const Merged_regions regions = find_level_sets(segment, orders);
    Search_workspace& own = m_workspaces.own();
    own.partition.select(segment);
    return make_cuts(segment, own.choose(own.partition, segment, orders, regions, accept));
  }

  // The level sets of all orders, and, after the last order, the regions.
  Merged_regions find_level_sets(const Segment& segment, Orders& orders)
  {
    Merged_regions regions;
    for_each(orders.size() + 1,
             [&](Search_workspace& workspace, std::size_t i)
             {
               workspace.partition.select(segment);
               if (i == orders.size())
                 regions = workspace.merge_regions(workspace.partition, segment);
               else
                 orders[i].level_sets = workspace.sweep(workspace.partition, orders[i].order, segment.area);
             });
    return regions;
  }

  // The different cuts around the candidates. Around a tip there is always something to be cut off if it is asked for. A region is
  // a guess: there is no cut around a wrong one.
  std::vector<Cut> make_cuts(const Segment& segment, const std::vector<Candidate>& candidates)
  {
    std::vector<std::optional<Cut>> cuts(candidates.size());
    for_each(candidates.size(),
             [&](Search_workspace& workspace, std::size_t i)
             {
               m_execution.progress(static_cast<double>(i) / static_cast<double>(candidates.size()));
               std::optional<Cut> cut = workspace.cutter.cut_around(segment, candidates[i].nodes);
               if (cut && (cut->value >= 0 || !candidates[i].is_region))
                 cuts[i] = std::move(cut);
             });
    std::vector<Cut> result;
    for (std::optional<Cut>& cut : cuts)
      add_different(result, std::move(cut));
    sort_best_first(result);
    return result;
  }

  const Indexed_surface& m_surface;
  const Graphs_of_surface& m_graphs;
  const std::optional<Any_distance>& m_distance;
  Execution& m_execution;
  Thread_workspaces<Search_workspace> m_workspaces;
  std::size_t m_number_of_runs = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_SEGMENT_SEARCH_H
