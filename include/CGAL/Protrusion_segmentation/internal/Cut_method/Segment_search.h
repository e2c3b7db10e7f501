// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEGMENT_SEARCH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEGMENT_SEARCH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Tip_orders.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/coarsen_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/distance_orders.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Searches segments of a coarse graph for cuts, one segment after the other: first its tips, then borders. Copies have
// their own work arrays, so that each thread can have one.
class Segment_search
{
public:
  using Index = Indexed_surface::Index;
  using Nodes = Graph_partition::Nodes;

  // The arguments must outlive the object. Without a distance, tips and level sets are those of the coarse graph.
  Segment_search(const Indexed_surface& surface,
                 const Coarse_graph& coarse,
                 const std::optional<Any_distance>& distance,
                 const Cut_policy& policy,
                 Execution& execution)
    : m_surface(surface),
      m_coarse(coarse),
      m_distance(distance),
      m_policy(policy),
      m_execution(execution),
      m_partition(coarse.graph, std::vector<Index>(coarse.graph.number_of_nodes(), 0)),
      m_search(m_partition, policy, execution),
      m_tip_orders(m_partition, execution)
  {}
  Segment_search(const Segment_search& other)
    : Segment_search(other.m_surface, other.m_coarse, other.m_distance, other.m_policy, other.m_execution)
  {}
  Segment_search& operator=(const Segment_search&) = delete;

  Graph_partition& partition() { return m_partition; }
  Tip_orders& tip_orders() { return m_tip_orders; }
  const Tip_orders& tip_orders() const { return m_tip_orders; }

  // Calls `visit(order)` with the nodes of segment `s` by their distances from each of its tips.
  template <typename Visit>
  void orders(Index s, const Nodes& nodes, Visit visit)
  {
    const Stage_scope stage(m_execution.observer(), Stage::TIPS);
    m_execution.check();
    select(s, nodes);
    if (!m_distance)
      return m_tip_orders.from_all_tips(s, nodes, visit);
    for (Nodes& order : distance_orders(m_surface, nodes, m_coarse.node, *m_distance, m_execution))
      visit(std::move(order));
  }

  Merged_regions regions(Index s, const Nodes& nodes)
  {
    const Stage_scope stage(m_execution.observer(), Stage::BORDERS);
    m_execution.check();
    select(s, nodes);
    return m_search.regions(s, nodes);
  }

  void find_level_sets(Index s, const Nodes& nodes, bool descending, Cut_search::Sweeps& sweeps)
  {
    const Stage_scope stage(m_execution.observer(), Stage::BORDERS);
    m_execution.check();
    select(s, nodes);
    m_search.find_level_sets(nodes, descending, sweeps);
  }

  std::size_t most_candidates() const { return m_search.most_candidates(); }

  // Calls `visit(candidate)` with what might be cut off from segment `s` with the given nodes.
  template <typename Visit>
  void candidates(Index s, const Nodes& nodes, const Cut_search::Candidate_sources& sources, Visit visit)
  {
    const Stage_scope stage(m_execution.observer(), Stage::BORDERS);
    select(s, nodes);
    m_search.candidates(s, nodes, sources, Cut_search::Accept_all(), visit);
  }

  // The cut around one of them, if there is any.
  std::optional<Cut> cut_around(Index s, const Nodes& nodes, const Cut_search::Candidate& candidate)
  {
    const Stage_scope stage(m_execution.observer(), Stage::BORDERS);
    select(s, nodes);
    return m_search.cut_around(s, nodes, candidate);
  }

  // The cut around some of its nodes as they are, if there is any.
  std::optional<Cut> cut_without_search(Index s, const Nodes& nodes, const Nodes& side)
  {
    const Stage_scope stage(m_execution.observer(), Stage::BORDERS);
    select(s, nodes);
    return m_search.cut_without_search(s, nodes, side);
  }

  // The cuts around those level sets and regions for which `accept(nodes)` holds, level sets around `tip` among them, best
  // first.
  template <typename Accept>
  std::vector<Cut> cuts_around_tip(Index tip, Index s, const Nodes& nodes, Accept accept)
  {
    Cut_search::Candidate_sources sources;
    orders(s, nodes, [&](Nodes order) { sources.add_order(std::move(order)); });
    sources.add_order(m_tip_orders.from_tip(s, tip).nodes);
    const Stage_scope stage(m_execution.observer(), Stage::BORDERS);
    return m_search.cuts(s, nodes, std::move(sources), accept);
  }

private:
  // From here on the partition is about this segment, which always has the same nodes.
  void select(Index s, const Nodes& nodes)
  {
    if (m_selected == s)
      return;
    for (Index i : nodes)
      m_partition.set_segment(i, s);
    m_selected = s;
  }

  const Indexed_surface& m_surface;
  const Coarse_graph& m_coarse;
  const std::optional<Any_distance>& m_distance;
  const Cut_policy& m_policy;
  Execution& m_execution;
  Graph_partition m_partition; // of the coarse graph: the segment that is searched against all else
  Index m_selected = Indexed_surface::no_face();
  Cut_search m_search;
  Tip_orders m_tip_orders;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEGMENT_SEARCH_H
