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
#include <CGAL/Protrusion_segmentation/internal/Execution/Thread_workspaces.h>

#include <cstddef>
#include <deque>
#include <iterator>
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
    : m_pool(pool),
      m_has_distance(distance),
      m_execution(execution),
      m_searches(surface, coarse, distance, policy, execution)
  {}

  Segment_search& of_segment() { return m_searches.own(); }
  std::size_t number_of_runs() const
  {
    std::size_t result = 0;
    m_searches.for_each([&](const Segment_search& search) { result += search.tip_orders().number_of_runs(); });
    return result;
  }

  // Gives a segment its cuts: those of a segment that has been searched, if there is one like it and any of them divide this
  // one; else those that are found.
  void operator()(Index segment)
  {
    if (m_pool.find_source(segment) != segment)
    {
      std::vector<Cut> cuts = taken_over(segment);
      if (!cuts.empty())
        return m_pool.take_over(segment, std::move(cuts));
    }
    m_pool.set_own_cuts(segment, m_pool[segment].own_cuts ? *m_pool[segment].own_cuts : found(segment));
  }

private:
  using Tasks = Thread_workspaces<Segment_search>::Tasks;

  const Nodes& nodes(Index segment) const { return m_pool[segment].nodes; }

  std::vector<Cut> taken_over(Index segment)
  {
    const std::vector<Nodes> sides = m_pool.sides_to_take_over(segment);
    std::vector<std::optional<Cut>> cuts(sides.size());
    m_searches.for_each_index(sides.size(), m_execution.is_parallel(), [&](Segment_search& of_thread, std::size_t i)
                              { cuts[i] = of_thread.cut_without_search(segment, nodes(segment), sides[i]); });
    return Cut_search::different(std::move(cuts));
  }

  // While one thread still looks for candidates, others search the cuts around those that it has found.
  std::vector<Cut> found(Index segment)
  {
    const Cut_search::Candidate_sources sources = find_sources(segment);
    const double most_candidates = static_cast<double>(of_segment().most_candidates());
    std::deque<std::optional<Cut>> cuts;
    Tasks tasks(m_searches, m_execution.is_parallel());
    of_segment().candidates(segment, nodes(segment), sources,
                            [&](Cut_search::Candidate candidate)
                            {
                              const double share = static_cast<double>(cuts.size()) / most_candidates;
                              std::optional<Cut>& cut = cuts.emplace_back();
                              tasks.run(
                                [this, segment, share, &cut, candidate = std::move(candidate)](Segment_search& of_thread)
                                {
                                  m_execution.progress(share);
                                  cut = of_thread.cut_around(segment, nodes(segment), candidate);
                                });
                            });
    tasks.wait();
    return Cut_search::different({std::make_move_iterator(cuts.begin()), std::make_move_iterator(cuts.end())});
  }

  // While one thread goes from tip to tip, others search regions and the level sets of those tips that are known. Distances
  // of the user's may use several threads themselves, and come before all else.
  Cut_search::Candidate_sources find_sources(Index segment)
  {
    Cut_search::Candidate_sources sources;
    Tasks tasks(m_searches, m_execution.is_parallel());
    const auto search_regions = [&]
    {
      tasks.run([&, segment](Segment_search& of_thread)
                { sources.regions = of_thread.regions(segment, nodes(segment)); });
    };
    if (!m_has_distance)
      search_regions();
    of_segment().orders(segment, nodes(segment),
                        [&](Nodes order)
                        {
                          Cut_search::Sweeps& sweeps = sources.add_order(std::move(order));
                          for (bool descending : {false, true})
                            tasks.run([this, segment, &sweeps, descending](Segment_search& of_thread)
                                      { of_thread.find_level_sets(segment, nodes(segment), descending, sweeps); });
                        });
    if (m_has_distance)
      search_regions();
    tasks.wait();
    return sources;
  }

  Segment_pool& m_pool;
  bool m_has_distance; // of the user's
  Execution& m_execution;
  Thread_workspaces<Segment_search> m_searches;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_POOL_SEARCH_H
