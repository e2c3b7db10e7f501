// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_BEAM_BEAM_SEARCH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_BEAM_BEAM_SEARCH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/Found_parts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/Segment_memo.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/Segment_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/Sure_cuts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/like_parts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/number_of_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Sizes_of_parts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Searches the cuts of a connected surface that are best together, for one more segment at a time. Greedy choice fails, because
// one good cut can block two better ones: the best sets of cuts are kept, a beam, and each is tried with its best
// further cuts. Sets of several sure cuts join the beam where it has come to sets of as many segments.
class Beam_search
{
public:
  using Index = Dual_graph::Index;

  // The arguments must outlive the object.
  Beam_search(const Volume_graph& graph, Segment_search& search, const Cut_options& options)
    : m_partition(graph),
      m_search(search),
      m_options(options),
      m_memo(graph),
      m_sure_cuts(graph, m_memo, options),
      m_found_parts(options.weights)
  {
    Nodes all(graph.number_of_nodes());
    std::iota(all.begin(), all.end(), Index(0));
    Cut_set whole;
    whole.segments.push_back(m_memo.find_or_add(std::move(all)));
    m_beam.push_back(whole);
    m_best.push_back(std::move(whole));
  }
  Beam_search(const Beam_search&) = delete;
  Beam_search& operator=(const Beam_search&) = delete;

  const Segment_memo& memo() const { return m_memo; }
  Segment_memo& memo() { return m_memo; }

  // The best set of cuts into `number_of_segments`; none if there are not as many. Cuts that gain little are searched for only
  // when there are no others, so that the sets are the same whether they are asked for by their number or not.
  const Cut_set* best(std::size_t number_of_segments)
  {
    while (m_best.size() < number_of_segments)
      if (!advance(m_options.least_protrusion) && !advance(-infinity))
        return nullptr;
    return &m_best[number_of_segments - 1];
  }

  // The same, but cuts that gain less than `Cut_options::least_protrusion` are not searched for.
  const Cut_set* best_protrusions(std::size_t number_of_segments)
  {
    while (m_best.size() < number_of_segments)
      if (!advance(m_options.least_protrusion))
        return nullptr;
    return &m_best[number_of_segments - 1];
  }

  // `step(n)` makes an object that lives while segment n + 1 is looked for.
  template <typename Step>
  std::size_t automatic_number(Step step)
  {
    return automatic_number_of_segments(
      [&](std::size_t n) -> std::optional<double>
      {
        [[maybe_unused]] const auto lives = step(n);
        return best_protrusions(n + 1) ? std::optional<double>(gain_of_last(n + 1)) : std::nullopt;
      },
      [this](std::size_t n) -> const Cut_set& { return *best(n); }, m_options);
  }

  // Whether more sure cuts of one segment were known than a number of segments has room for, when the beam came to that number:
  // what was asked for besides does not matter.
  bool knew_more_sure_cuts_than(std::size_t number_of_segments) const { return m_knew_more_sure_cuts[number_of_segments - 1]; }

  // What the last of a number of segments gains, of those that were asked for.
  double gain_of_last(std::size_t number_of_segments) const
  {
    return m_best[number_of_segments - 1].value - m_best[number_of_segments - 2].value;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // A further cut of a set, one of a segment's cuts, and what it adds to the value of the set.
  struct Choice
  {
    const Cut_set* set;
    Index segment;
    std::size_t cut;
    double gain;

    double value() const { return set->value + gain; }
  };

  // Makes the beam one of sets with one cut more, if that adds more than `least_gain` to the value of the best one.
  bool advance(double least_gain)
  {
    const double least = m_best.back().value + least_gain;
    std::vector<Cut_set> next = best_next_sets();
    for (std::vector<Index> ids = segments_to_search(next, least); !ids.empty(); ids = segments_to_search(next, least))
    {
      search(ids);
      next = best_next_sets();
    }
    make_sure_cuts();
    if (const auto sets = m_of_sure_cuts.find(m_best.size() + 1); sets != m_of_sure_cuts.end())
      for (const Cut_set& set : sets->second)
        add(next, set);
    std::stable_sort(next.begin(), next.end(), [](const Cut_set& a, const Cut_set& b) { return a.value > b.value; });
    next.resize((std::min)(next.size(), m_options.number_of_sets));
    if (next.empty() || next.front().value <= least)
      return false;
    m_best.push_back(next.front());
    m_beam = std::move(next);
    m_knew_more_sure_cuts.push_back(!m_of_sure_cuts.empty() && m_of_sure_cuts.rbegin()->first > m_best.size());
    return true;
  }

  void search(const std::vector<Index>& ids)
  {
    std::vector<const Segment*> segments;
    for (Index id : ids)
      segments.push_back(&m_memo[id].segment);
    std::vector<std::vector<Cut>> cuts = m_search(segments);
    const bool is_before_first_cut = m_best.size() == 1;
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      add_found_parts(ids[i], cuts[i]);
      if (is_before_first_cut && m_options.sure_log_odds < infinity)
        find_like_parts(m_options, cuts[i]);
      m_memo.set_cuts(ids[i], std::move(cuts[i]));
    }
  }

  // Measures the parts of a segment's cuts, and adds cuts around those that were found before and are like one that has been cut off.
  void add_found_parts(Index id, std::vector<Cut>& cuts)
  {
    const Segment& segment = m_memo[id].segment;
    const Sizes_of_parts measure(m_partition, m_options.weights, segment);
    measure(cuts);
    const auto set = std::find_if(m_beam.begin(), m_beam.end(), [&](const Cut_set& other)
                                  { return std::binary_search(other.segments.begin(), other.segments.end(), id); });
    const std::vector<Nodes> found = m_found_parts.like_those_of(*set, segment, cuts);
    m_found_parts.add(cuts);
    if (found.empty())
      return;
    for (const Nodes& nodes : found)
      add_different(cuts, m_search.cut_around(segment, nodes));
    measure(cuts);
    sort_best_first(cuts);
  }

  // The sure cuts of segments of the beam that have been searched since the last time.
  void make_sure_cuts()
  {
    for (const Cut_set& set : m_beam)
      for (Index s : set.segments)
        if (m_memo[s].is_searched && m_with_sure_cuts.insert(s).second)
          for (Cut_set& further : m_sure_cuts(set, s))
            m_of_sure_cuts[further.segments.size()].push_back(std::move(further));
  }

  // Of sets of the same segments the one is kept that is worth most.
  static void add(std::vector<Cut_set>& sets, Cut_set set)
  {
    const auto same =
      std::find_if(sets.begin(), sets.end(), [&](const Cut_set& other) { return other.segments == set.segments; });
    if (same == sets.end())
      sets.push_back(std::move(set));
    else if (set.value > same->value)
      *same = std::move(set);
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
    sort_by_value(choices);
    std::vector<Cut_set> sets;
    for (std::size_t i = 0; i < choices.size() && sets.size() < m_options.number_of_sets; ++i)
    {
      const auto& [before, segment, cut, gain] = choices[i];
      add(sets, before->with(m_memo.made_cut(segment, m_memo[segment].cuts[cut], gain)));
    }
    return sets;
  }

  // The best further cuts of a set, as far as its segments have been searched. Equal ones are in the order of its segments.
  std::vector<Choice> best_choices(const Cut_set& set) const
  {
    std::vector<Choice> result;
    for (Index s : set.in_order_of_cuts())
      for (std::size_t c = 0; c < m_memo[s].cuts.size(); ++c)
        result.push_back({&set, s, c, set.gain(m_memo[s].cuts[c], m_options.weights)});
    sort_by_value(result);
    result.resize((std::min)(result.size(), m_options.cuts_of_set));
    return result;
  }

  static void sort_by_value(std::vector<Choice>& choices)
  {
    std::stable_sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) { return a.value() > b.value(); });
  }

  // The most promising segments of the beam that have not been searched yet and might change which sets of at least some
  // value are the best next ones. The promise is the most that a cut of a segment of that area usually gains. Many small segments
  // promise too little to be searched.
  std::vector<Index> segments_to_search(const std::vector<Cut_set>& next, double least) const
  {
    if (next.size() == m_options.number_of_sets)
      least = (std::max)(least, next.back().value);
    std::vector<std::pair<double, Index>> promises; // the largest first; of equals the first segment
    for (const Cut_set& set : m_beam)
    {
      const std::vector<Choice> choices = best_choices(set);
      const double least_of_set =
        choices.size() < m_options.cuts_of_set ? least : (std::max)(least, choices.back().value());
      for (Index s : set.segments)
      {
        const double promise = set.value + m_options.largest_relative_value * m_memo[s].segment.area;
        if (!m_memo[s].is_searched && promise >= least_of_set)
          promises.emplace_back(-promise, s);
      }
    }
    std::sort(promises.begin(), promises.end());
    std::vector<Index> result;
    for (const auto& [promise, s] : promises)
      if (result.size() < m_options.searched_at_once && std::find(result.begin(), result.end(), s) == result.end())
        result.push_back(s);
    return result;
  }

  Graph_partition m_partition;
  Segment_search& m_search;
  const Cut_options& m_options;
  Segment_memo m_memo;
  Sure_cuts m_sure_cuts;
  Found_parts m_found_parts;
  std::set<Index> m_with_sure_cuts; // segments whose sure cuts have been made,
  std::map<std::size_t, std::vector<Cut_set>> m_of_sure_cuts; // and the sets of these, by their numbers of segments
  std::vector<Cut_set> m_beam; // of equally many cuts, the best first
  std::vector<Cut_set> m_best; // for every number of segments from 1 on
  std::vector<bool> m_knew_more_sure_cuts = {false}; // for each of these numbers
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_BEAM_BEAM_SEARCH_H
