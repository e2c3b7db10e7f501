// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_CUTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_CUTS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_set.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Pool_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Segment_pool.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Segment_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/disk_clusters.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/make_coarse_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/make_weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/measure_volumes.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/straighten_borders.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/distinct_tips.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A connected surface as the cut method sees it: the faces, groups of these if there are many, and a coarse graph that
// cuts are searched on.
struct Cut_graphs
{
  Weighted_dual_graph fine;
  std::optional<Coarse_graph> groups;
  Coarse_graph coarse;

  Cut_graphs(const Indexed_surface& surface, const Cut_policy& policy, Execution& execution)
  {
    const Stage_scope stage(execution.observer(), Stage::PREPARATION);
    std::optional<Disk_clusters> disks;
    Weighted_dual_graph_maker maker(surface, policy, execution, fine);
    maker.measure();
    call_both(
      execution.is_parallel(), [&] { maker.weigh(); },
      [&]
      {
        if (has_disks_of_nodes(fine))
          disks.emplace(select_disks(fine, execution));
      });
    groups = make_groups(fine, execution);
    coarse = make_coarse_graph(fine, std::move(disks), groups, execution);
    straighten_borders(surface, fine, coarse.node, coarse.graph, execution.is_parallel());
    measure_volumes(surface, coarse.node, coarse.graph, execution.is_parallel());
    coarse.graph.keep_seam_lengths();
    decltype(fine.centre)().swap(fine.centre); // only the coarse graph is made of these
  }
};

// Searches the cuts of a connected surface that are best together, for one more segment at a time. Not the best cut of
// all is made, again and again: a cut that is good by itself may spoil two better ones. The best sets of cuts are
// kept, a beam, and each is tried with its best further cuts.
class Component_cuts
{
public:
  using Index = Indexed_surface::Index;
  using Nodes = Graph_partition::Nodes;

  // The arguments must outlive the object. Without a distance, tips and level sets are those of the coarse graph.
  Component_cuts(const Indexed_surface& surface,
                 const std::optional<Any_distance>& distance,
                 Execution& execution,
                 const Cut_policy& policy)
    : m_surface(surface),
      m_execution(execution),
      m_policy(policy),
      m_graphs(surface, policy, execution),
      m_pool(m_graphs.coarse.graph, policy.least_overlap_of_copies()),
      m_pool_search(m_pool, surface, m_graphs.coarse, distance, policy, execution)
  {
    Nodes all(m_graphs.coarse.graph.number_of_nodes());
    std::iota(all.begin(), all.end(), Index(0));
    Cut_set whole;
    whole.segments.push_back(m_pool.find_or_add(std::move(all)));
    m_beam.push_back(whole);
    m_best.push_back(std::move(whole));
  }
  Component_cuts(const Component_cuts&) = delete;
  Component_cuts& operator=(const Component_cuts&) = delete;

  const Indexed_surface& surface() const { return m_surface; }
  const Cut_graphs& graphs() const { return m_graphs; }
  const Segment_pool& pool() const { return m_pool; }
  std::size_t number_of_runs() const { return m_pool_search.number_of_runs(); }

  // The best set of cuts into `number_of_segments`; none if there are not as many, or if one of the cuts would bring
  // `least_gain` or less to the value of the best set.
  const Cut_set* best(std::size_t number_of_segments, double least_gain = -infinity)
  {
    while (m_best.size() < number_of_segments)
      if (!advance(least_gain))
        return nullptr;
    return &m_best[number_of_segments - 1];
  }

  // For tips of protrusions, in their order: cuts off the protrusion with the best border that has the tip, but none
  // of the others, and no more than half of the surface.
  Cut_set cuts_of_tips(const std::vector<Index>& faces)
  {
    const std::vector<Index> tips = nodes_of_tips(faces);
    Cut_set result = m_best.front();
    for (std::size_t t = 0; t < faces.size(); ++t)
    {
      m_execution.check();
      const Index tip = tips[t];
      const Index segment = *std::find_if(result.segments.begin(), result.segments.end(), [&](Index s)
                                          { return contains(m_pool[s].nodes, tip); });
      if (const std::optional<Cut> cut = cut_of_tip(segment, tip, tips))
      {
        const Index inner = m_pool.find_or_add(cut->inner);
        const Index outer = m_pool.find_or_add(m_pool.other_side(segment, cut->inner));
        result = result.with({segment, inner, outer, cut->value, cut->probability});
      }
    }
    return result;
  }

  // Begins again, by a policy that has become another one in how it weighs clues. What has been searched keeps its cuts;
  // regions around which there was none by the former weights stay left out.
  void value_anew()
  {
    m_pool.begin_again([this](Cut& cut) { value_by_clues(m_policy, cut); });
    m_best.resize(1);
    m_beam = m_best;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t cuts_of_set = 4; // with 6 the Rand index error is no lower

  // of one segment
  Segment_search& search() { return m_pool_search.of_segment(); }

  static bool contains(const Nodes& ascending, Index node)
  {
    return std::binary_search(ascending.begin(), ascending.end(), node);
  }

  Cut_set::Made_cut made_cut(Index segment, std::size_t number)
  {
    const auto [inner, outer] = m_pool.sides(segment, number);
    const Cut& cut = m_pool[segment].cuts[number];
    return {segment, inner, outer, cut.value, cut.probability};
  }

  // A further cut of a set: the number of a cut of one of its segments, and the value of the set with it.
  struct Choice
  {
    const Cut_set* set;
    Index segment;
    std::size_t cut;
    double value;
  };

  // Makes the beam one of sets with one cut more, if that adds more than `least_gain` to the value of the best one.
  bool advance(double least_gain)
  {
    const double least = m_best.back().value + least_gain;
    std::vector<Cut_set> next = best_next_sets();
    while (const std::optional<Index> segment = segment_to_search(next, least))
    {
      m_pool_search(*segment);
      next = best_next_sets();
    }
    if (next.empty() || next.front().value <= least)
      return false;
    m_best.push_back(next.front());
    m_beam = std::move(next);
    return true;
  }

  // The best different sets of one cut more, as far as segments have been searched.
  std::vector<Cut_set> best_next_sets()
  {
    std::vector<Choice> choices;
    for (const Cut_set& set : m_beam)
    {
      const std::vector<Choice> of_set = best_choices(set);
      choices.insert(choices.end(), of_set.begin(), of_set.end());
    }
    std::stable_sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) { return a.value > b.value; });
    std::vector<Cut_set> sets;
    for (std::size_t i = 0; i < choices.size() && sets.size() < m_policy.number_of_sets(); ++i)
    {
      const Index segment = choices[i].segment;
      Cut_set set = choices[i].set->with(made_cut(segment, choices[i].cut));
      const auto is_same = [&](const Cut_set& other) { return other.segments == set.segments; };
      if (std::none_of(sets.begin(), sets.end(), is_same))
        sets.push_back(std::move(set));
    }
    return sets;
  }

  // The best further cuts of a set, as far as its segments have been searched. Equal ones are in the order of its segments.
  std::vector<Choice> best_choices(const Cut_set& set) const
  {
    std::vector<Choice> result;
    for (Index s : set.in_order_of_cuts())
      for (std::size_t c = 0; c < (std::min)(m_pool[s].cuts.size(), cuts_of_set); ++c)
        result.push_back({&set, s, c, set.value + m_pool[s].cuts[c].value});
    std::stable_sort(result.begin(), result.end(), [](const Choice& a, const Choice& b) { return a.value > b.value; });
    result.resize((std::min)(result.size(), cuts_of_set));
    return result;
  }

  // Of the segments of the beam that have not been searched yet, if the cuts of any might change which sets of at least some
  // value are the best next ones, the most promising one. Many small segments are never searched. One comes after the other,
  // whatever the number of threads, since segments take over the cuts of those before.
  std::optional<Index> segment_to_search(const std::vector<Cut_set>& next, double least) const
  {
    if (next.size() == m_policy.number_of_sets())
      least = (std::max)(least, next.back().value);
    std::optional<Index> result;
    double largest_promise = -infinity;
    for (const Cut_set& set : m_beam)
    {
      const std::vector<Choice> choices = best_choices(set);
      const double least_of_set = choices.size() < cuts_of_set ? least : (std::max)(least, choices.back().value);
      for (Index s : set.segments)
      {
        const double promise = set.value + m_policy.largest_relative_value() * m_pool[s].area;
        if (m_pool[s].is_searched || promise < least_of_set)
          continue;
        if (promise > largest_promise || (promise == largest_promise && s < *result))
        {
          largest_promise = promise;
          result = s;
        }
      }
    }
    return result;
  }

  // The nodes of the picked tips, and of further ones where there are few.
  std::vector<Index> nodes_of_tips(const std::vector<Index>& faces)
  {
    std::vector<double> to_nearest_tip(m_graphs.coarse.graph.number_of_nodes(),
                                       (std::numeric_limits<double>::max)());
    std::vector<Index> tips;
    while (!faces.empty() && tips.size() < (std::max)(faces.size(), least_number_of_tips))
    {
      const auto farthest = std::max_element(to_nearest_tip.begin(), to_nearest_tip.end());
      tips.push_back(tips.size() < faces.size() ? m_graphs.coarse.node[faces[tips.size()]]
                                                : static_cast<Index>(farthest - to_nearest_tip.begin()));
      const Nodes_by_distance from_tip = search().tip_orders().from_tip(m_best.front().segments.front(), tips.back());
      for (std::size_t i = 0; i < from_tip.nodes.size(); ++i)
        to_nearest_tip[from_tip.nodes[i]] = (std::min)(to_nearest_tip[from_tip.nodes[i]], from_tip.distances[i]);
    }
    return tips;
  }

  std::optional<Cut> cut_of_tip(Index s, Index tip, const std::vector<Index>& tips)
  {
    std::vector<bool> is_other_tip(m_graphs.coarse.graph.number_of_nodes(), false);
    for (Index other : tips)
      is_other_tip[other] = other != tip; // two tips in one node are one
    const auto has_this_tip_only = [&](const Nodes& nodes)
    {
      return 2 * search().partition().area(nodes) <= 1 && std::find(nodes.begin(), nodes.end(), tip) != nodes.end() &&
             std::none_of(nodes.begin(), nodes.end(), [&](Index i) { return is_other_tip[i]; });
    };
    std::optional<Cut> best;
    for (Cut& cut : search().cuts_around_tip(tip, s, m_pool[s].nodes, has_this_tip_only))
    {
      if (!contains(cut.inner, tip))
        cut.inner = m_pool.other_side(s, cut.inner);
      if (has_this_tip_only(cut.inner) && (!best || cut.value > best->value))
        best = std::move(cut);
    }
    return best;
  }

  const Indexed_surface& m_surface;
  Execution& m_execution;
  const Cut_policy& m_policy;
  Cut_graphs m_graphs;
  Segment_pool m_pool;
  Pool_search m_pool_search;
  std::vector<Cut_set> m_beam; // of equally many cuts, the best first
  std::vector<Cut_set> m_best; // for every number of segments from 1 on
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_CUTS_H
