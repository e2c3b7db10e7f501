// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_GREEDY_SEARCH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_GREEDY_SEARCH_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Sizes_of_parts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Found_parts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_memo.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Sure_cuts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/like_parts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/number_of_segments.h>

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

// Searches the cuts of a connected surface: each time the one of all segments that is worth most. Where several sure cuts of one
// segment are worth more together than as many cuts one at a time, they take their place.
class Greedy_search
{
public:
  using Index = Dual_graph::Index;

  // The arguments must outlive the object.
  Greedy_search(const Volume_graph& graph, Segment_search& search, const Cut_options& options)
    : m_partition(graph),
      m_search(search),
      m_options(options),
      m_memo(graph),
      m_sure_cuts(graph, m_memo, options),
      m_found_parts(options.weights),
      m_best(1)
  {
    Nodes all(graph.number_of_nodes());
    std::iota(all.begin(), all.end(), Index(0));
    m_best.front().segments.push_back(m_memo.find_or_add(std::move(all)));
  }
  Greedy_search(const Greedy_search&) = delete;
  Greedy_search& operator=(const Greedy_search&) = delete;

  const Segment_memo& memo() const { return m_memo; }
  Segment_memo& memo() { return m_memo; }

  // The cuts into `number_of_segments`; none if there are not as many. Cuts that gain little are searched for only
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

  // Whether more sure cuts of one segment were known than a number of segments has room for, when the search came to that number:
  // what was asked for besides does not matter.
  bool knew_more_sure_cuts_than(std::size_t number_of_segments) const { return m_knew_more_sure_cuts[number_of_segments - 1]; }

  // What the last of a number of segments gains, of those that were asked for.
  double gain_of_last(std::size_t number_of_segments) const
  {
    return m_best[number_of_segments - 1].value - m_best[number_of_segments - 2].value;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // One of a segment's cuts, and what it adds to the value of the set.
  struct Choice
  {
    Index segment;
    std::size_t cut;
    double gain;
  };

  // Finds the set with one cut more, if that adds more than `least_gain` to the value.
  bool advance(double least_gain)
  {
    const std::optional<Choice> choice = best_choice(least_gain);
    add_sure_cuts();
    const Cut_set& last = m_best.back();
    std::optional<Cut_set> next;
    if (choice)
      next = last.with(m_memo.made_cut(choice->segment, m_memo[choice->segment].cuts[choice->cut], choice->gain));
    for (const Cut_set& set : m_of_sure_cuts[m_best.size() + 1])
      if (!next || set.value > next->value)
        next = set;
    if (!next || next->value <= last.value + least_gain)
      return false;
    m_best.push_back(std::move(*next));
    m_knew_more_sure_cuts.push_back(m_of_sure_cuts.rbegin()->first > m_best.size());
    return true;
  }

  // The best further cut. The segments that promise more are searched before, if that is at least `least_gain`.
  std::optional<Choice> best_choice(double least_gain)
  {
    while (true)
    {
      const std::optional<Choice> choice = best_known_choice();
      const std::optional<Index> segment = largest_unsearched(choice ? (std::max)(least_gain, choice->gain) : least_gain);
      if (!segment)
        return choice;
      search(*segment);
    }
  }

  // Of equal ones the first in the order of the segments.
  std::optional<Choice> best_known_choice() const
  {
    std::optional<Choice> best;
    for (Index s : m_best.back().in_order_of_cuts())
      for (std::size_t c = 0; c < m_memo[s].cuts.size(); ++c)
        if (const double gain = m_best.back().gain(m_memo[s].cuts[c], m_options.weights); !best || gain > best->gain)
          best = Choice{s, c, gain};
    return best;
  }

  // The largest segment that has not been searched yet, if the most that a cut of a segment of that area usually gains is at least
  // `least_gain`. Many small segments promise too little to be searched.
  std::optional<Index> largest_unsearched(double least_gain) const
  {
    const auto area = [this](Index s) { return m_memo[s].segment.area; };
    std::optional<Index> largest;
    for (Index s : m_best.back().segments)
      if (!m_memo[s].is_searched && m_options.largest_relative_value * area(s) >= least_gain && (!largest || area(s) > area(*largest)))
        largest = s;
    return largest;
  }

  void search(Index id)
  {
    std::vector<Cut> cuts = m_search(m_memo[id].segment);
    add_found_parts(m_memo[id].segment, cuts);
    if (m_best.size() == 1 && m_options.sure_log_odds < infinity)
      find_like_parts(m_options, cuts);
    m_memo.set_cuts(id, std::move(cuts));
  }

  // Measures the parts of a segment's cuts, and adds cuts around those that were found before and are like one that has been cut off.
  void add_found_parts(const Segment& segment, std::vector<Cut>& cuts)
  {
    const Sizes_of_parts measure(m_partition, m_options.weights, segment);
    measure(cuts);
    const std::vector<Nodes> found = m_found_parts.like_those_of(m_best.back(), segment, cuts);
    m_found_parts.add(cuts);
    if (found.empty())
      return;
    for (const Nodes& nodes : found)
      add_different(cuts, m_search.cut_around(segment, nodes));
    measure(cuts);
    sort_best_first(cuts);
  }

  // The sets of sure cuts of segments that have been searched since the last time.
  void add_sure_cuts()
  {
    for (Index s : m_best.back().segments)
      if (m_memo[s].is_searched && m_with_sure_cuts.insert(s).second)
        for (Cut_set& further : m_sure_cuts(m_best.back(), s))
          m_of_sure_cuts[further.segments.size()].push_back(std::move(further));
  }

  Graph_partition m_partition;
  Segment_search& m_search;
  const Cut_options& m_options;
  Segment_memo m_memo;
  Sure_cuts m_sure_cuts;
  Found_parts m_found_parts;
  std::set<Index> m_with_sure_cuts; // segments whose sure cuts have been made,
  std::map<std::size_t, std::vector<Cut_set>> m_of_sure_cuts; // and the sets of these, by their numbers of segments
  std::vector<Cut_set> m_best;                                // for every number of segments from 1 on
  std::vector<bool> m_knew_more_sure_cuts = {false};          // for each of these numbers
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_GREEDY_SEARCH_H
