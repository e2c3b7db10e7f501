// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_BEAM_SEGMENT_SEARCH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_BEAM_SEGMENT_SEARCH_H

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

// Searches segments for their best cuts, step by step: orders of their nodes by the distance from tips, level sets of
// these and regions, candidates, and minimum cuts near these. Each step is one loop over the
// work of all segments, so that several threads share it.
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
      m_options(options),
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

  // For each segment its cuts, best first.
  std::vector<std::vector<Cut>> operator()(const std::vector<const Segment*>& segments)
  {
    std::vector<Work> all;
    for (const Segment* segment : segments)
      all.emplace_back(*segment);
    find_orders(all);
    const Stage_scope stage(m_execution.observer(), Stage::BORDERS);
    find_level_sets(all);
    for_each(all.size(), 1, [&](Search_workspace& workspace, std::size_t s, std::size_t)
             { choose_candidates(workspace, all[s], [](const Nodes&) { return true; }); });
    make_cuts(all);
    std::vector<std::vector<Cut>> result;
    for (Work& work : all)
      result.push_back(best_different(std::move(work.cuts)));
    return result;
  }

  // The best cut around a level set or region for which `accept(nodes)` holds, level sets around `tip` among them; it has
  // the tip on its inner side, for which `accept` holds as well.
  template <typename Accept>
  std::optional<Cut> cut_of_tip(const Segment& segment, Index tip, Accept accept)
  {
    std::vector<Work> all(1, Work(segment));
    find_orders(all);
    add_order(all.front(), from_tip(segment, tip).nodes);
    const Stage_scope stage(m_execution.observer(), Stage::BORDERS);
    find_level_sets(all);
    choose_candidates(m_workspaces.own(), all.front(), accept);
    make_cuts(all);
    std::optional<Cut> best;
    for (Cut& cut : best_different(std::move(all.front().cuts)))
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
  // What is known of a segment while it is searched.
  struct Work
  {
    const Segment* segment;
    std::vector<Ordered_level_sets> orders = {};
    Merged_regions regions = {};
    std::vector<Candidate> candidates = {};
    std::vector<std::optional<Cut>> cuts = {}; // of the candidates

    explicit Work(const Segment& s) : segment(&s) {}
  };

  // Calls `body(workspace, s, i)` for all i below `number` of every segment s.
  template <typename Body>
  void for_each(std::size_t segments, std::size_t number, Body body)
  {
    m_workspaces.for_each_index(segments * number, m_execution.is_parallel(),
                                [&](Search_workspace& workspace, std::size_t n)
                                {
                                  m_execution.check();
                                  body(workspace, n / number, n % number);
                                });
  }

  static void add_order(Work& work, Nodes order)
  {
    Nodes reverse(order.rbegin(), order.rend());
    work.orders.push_back({std::move(order), {}});
    work.orders.push_back({std::move(reverse), {}});
  }

  // The orders of the nodes, from near and from far. A distance of the user's may use several threads itself.
  void find_orders(std::vector<Work>& all)
  {
    const Stage_scope stage(m_execution.observer(), Stage::TIPS);
    std::vector<std::vector<Nodes>> orders(all.size());
    if (m_distance)
      for (std::size_t s = 0; s < all.size(); ++s)
        orders[s] = distance_orders(m_surface, all[s].segment->nodes, m_graphs.node_of_face, *m_distance, m_execution);
    else
      for_each(all.size(), 1, [&](Search_workspace& workspace, std::size_t s, std::size_t)
               { orders[s] = workspace.tip_orders(*all[s].segment, m_execution); });
    for (std::size_t s = 0; s < all.size(); ++s)
    {
      m_number_of_runs += m_distance ? 0 : orders[s].size() + 1; // and one from the centre
      for (Nodes& order : orders[s])
        add_order(all[s], std::move(order));
    }
  }

  // The level sets of all orders, and, after the last order, the regions.
  void find_level_sets(std::vector<Work>& all)
  {
    std::size_t most_orders = 0;
    for (const Work& work : all)
      most_orders = (std::max)(most_orders, work.orders.size());
    for_each(all.size(), most_orders + 1,
             [&](Search_workspace& workspace, std::size_t s, std::size_t i)
             {
               Work& work = all[s];
               if (i < most_orders && i >= work.orders.size())
                 return;
               workspace.partition.select(*work.segment);
               if (i == most_orders)
                 work.regions = workspace.merge_regions(workspace.partition, *work.segment);
               else
                 work.orders[i].level_sets = workspace.sweep(workspace.partition, work.orders[i].order, work.segment->area);
             });
  }

  template <typename Accept>
  void choose_candidates(Search_workspace& workspace, Work& work, Accept accept) const
  {
    workspace.partition.select(*work.segment);
    work.candidates = workspace.choose(workspace.partition, *work.segment, work.orders, work.regions, accept);
    work.cuts.resize(work.candidates.size());
  }

  // The cuts around the candidates. Around a tip there is always something to be cut off if it is asked for; a region is a
  // guess, and there is no cut if it is a wrong one.
  void make_cuts(std::vector<Work>& all)
  {
    const std::size_t most = m_options.level_sets + m_options.regions;
    for_each(all.size(), most,
             [&](Search_workspace& workspace, std::size_t s, std::size_t i)
             {
               m_execution.progress(static_cast<double>(s * most + i) / static_cast<double>(all.size() * most));
               if (i >= all[s].candidates.size())
                 return;
               const Candidate& candidate = all[s].candidates[i];
               std::optional<Cut> cut = workspace.cutter.cut_around(*all[s].segment, candidate.nodes);
               if (cut && (cut->value >= 0 || !candidate.is_region))
                 all[s].cuts[i] = std::move(cut);
             });
  }

  static std::vector<Cut> best_different(std::vector<std::optional<Cut>> cuts)
  {
    std::vector<Cut> result;
    for (std::optional<Cut>& cut : cuts)
      add_different(result, std::move(cut));
    sort_best_first(result);
    return result;
  }

  const Indexed_surface& m_surface;
  const Graphs_of_surface& m_graphs;
  const std::optional<Any_distance>& m_distance;
  const Cut_options& m_options;
  Execution& m_execution;
  Thread_workspaces<Search_workspace> m_workspaces;
  std::size_t m_number_of_runs = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_BEAM_SEGMENT_SEARCH_H
