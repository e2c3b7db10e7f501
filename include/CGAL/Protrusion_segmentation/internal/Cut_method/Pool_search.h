// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_POOL_SEARCH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_POOL_SEARCH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Segment_pool.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Segment_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/coarsen_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Finds the cuts of segments of a pool, in parallel if that is wanted.
class Pool_search
{
public:
  using Index = Indexed_surface::Index;
  using Nodes = Graph_partition::Nodes;

  // The arguments must outlive the object. Without a distance, tips and level sets are those of the coarse graph.
  Pool_search(Segment_pool& pool,
              const Indexed_surface& surface,
              const Coarse_graph& coarse,
              const std::optional<Any_distance>& distance,
              const Cut_policy& policy,
              Execution& execution)
    : m_pool(pool), m_distance(distance), m_execution(execution), m_search(surface, coarse, distance, policy, execution)
  {}

  Segment_search& of_segment() { return m_search; }
  std::size_t number_of_runs() const { return m_search.tip_orders().number_of_runs() + m_runs_of_copies; }

  // Gives different segments their cuts: those of their source, if that is another segment, which has been searched, and has
  // any that divide them.
  void operator()(const std::vector<Index>& segments)
  {
    std::vector<Index> to_search, others;
    for (Index s : segments)
      (m_pool[s].source == s ? to_search : others).push_back(s);
    std::vector<std::vector<Cut>> taken_over(others.size());
    for_each_index(
      others.size(), m_execution.is_parallel(), m_search,
      [&](Segment_search& search, std::size_t i)
      { taken_over[i] = search.cuts_without_search(others[i], nodes(others[i]), m_pool.sides_to_take_over(others[i])); },
      [](const Segment_search&) {});
    for (std::size_t i = 0; i < others.size(); ++i)
      if (taken_over[i].empty())
        to_search.push_back(others[i]);
      else
        m_pool.set_cuts(others[i], std::move(taken_over[i]));
    search(to_search);
  }

private:
  const Nodes& nodes(Index segment) const { return m_pool[segment].nodes; }

  // A distance of the user's is asked by one thread at a time, it may use several itself.
  void search(const std::vector<Index>& segments)
  {
    struct Task
    {
      std::size_t i, candidate;
    };
    std::vector<std::vector<Cut_search::Candidate>> candidates(segments.size());
    for_each_index(
      segments.size(), m_execution.is_parallel() && !m_distance, m_search,
      [&](Segment_search& search, std::size_t i)
      { candidates[i] = search.candidates(segments[i], nodes(segments[i])); },
      [this](const Segment_search& search) { count_runs(search); });

    std::vector<Task> tasks; // segments are too few, and too different in size, to share the work by
    std::vector<std::vector<std::optional<Cut>>> cuts(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      cuts[i].resize(candidates[i].size());
      for (std::size_t c = 0; c < candidates[i].size(); ++c)
        tasks.push_back({i, c});
    }
    for_each_index(
      tasks.size(), m_execution.is_parallel(), m_search,
      [&](Segment_search& search, std::size_t t)
      {
        m_execution.progress(static_cast<double>(t) / static_cast<double>(tasks.size()));
        const auto [i, c] = tasks[t];
        cuts[i][c] = search.cut_around(segments[i], nodes(segments[i]), candidates[i][c]);
      },
      [](const Segment_search&) {});
    for (std::size_t i = 0; i < segments.size(); ++i)
      m_pool.set_cuts(segments[i], Cut_search::different(std::move(cuts[i])));
  }

  void count_runs(const Segment_search& search)
  {
    if (&search != &m_search)
      m_runs_of_copies += search.tip_orders().number_of_runs();
  }

  Segment_pool& m_pool;
  const std::optional<Any_distance>& m_distance;
  Execution& m_execution;
  Segment_search m_search;
  std::size_t m_runs_of_copies = 0; // that other threads have had of the search
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_POOL_SEARCH_H
