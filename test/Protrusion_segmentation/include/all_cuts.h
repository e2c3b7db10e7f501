// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sets of cuts by brute force.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_ALL_CUTS_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_ALL_CUTS_H

#include "components.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Sizes_of_parts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_memo.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_search.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace test_meshes {

// All cuts of any segment, as they are searched, of every segment that there is.
class All_cuts
{
public:
  using Cut_set = internal::Cut_set;

  explicit All_cuts(const Test_mesh& mesh)
    : m_surface(to_surface(mesh)),
      m_graphs(m_surface, default_options(), quiet_execution()),
      m_search(m_surface, m_graphs, m_distance, default_options(), quiet_execution()),
      m_memo(m_graphs.coarse),
      m_partition(m_graphs.coarse)
  {
    m_whole.segments.push_back(m_memo.find_or_add(all_nodes(m_graphs.coarse)));
  }

  // The largest value of all sets of that many cuts.
  double largest_value(std::size_t number_of_cuts)
  {
    std::map<std::vector<Index>, Cut_set> sets = {{m_whole.segments, m_whole}};
    for (std::size_t i = 0; i < number_of_cuts; ++i)
      sets = extended(sets);
    double largest = -infinity;
    for (const auto& item : sets)
      largest = (std::max)(largest, item.second.value);
    return largest;
  }

  // The best cut of all, again and again: the sets of no cut, of one, and so on.
  std::vector<Cut_set> greedy(std::size_t number_of_cuts)
  {
    std::vector<Cut_set> result = {m_whole};
    while (result.size() <= number_of_cuts)
    {
      const std::vector<Cut_set> further = with_one_more_cut(result.back());
      if (further.empty())
        break;
      result.push_back(*std::max_element(further.begin(), further.end(),
                                         [](const Cut_set& a, const Cut_set& b) { return a.value < b.value; }));
    }
    return result;
  }

  const internal::Segment_memo& memo() const { return m_memo; }

private:
  // The better one of sets with the same segments.
  std::map<std::vector<Index>, Cut_set> extended(const std::map<std::vector<Index>, Cut_set>& sets)
  {
    std::map<std::vector<Index>, Cut_set> result;
    for (const auto& item : sets)
      for (const Cut_set& set : with_one_more_cut(item.second))
      {
        const auto [found, is_new] = result.emplace(set.segments, set);
        if (!is_new && found->second.value < set.value)
          found->second = set;
      }
    return result;
  }

  std::vector<Cut_set> with_one_more_cut(const Cut_set& set)
  {
    std::vector<Cut_set> result;
    for (const Index s : set.segments)
      for (const internal::Cut& cut : cuts_of(s))
        result.push_back(set.with(m_memo.made_cut(s, cut, set.gain(cut, internal::Cut_weights()))));
    return result;
  }

  const std::vector<internal::Cut>& cuts_of(Index s)
  {
    if (!m_memo[s].is_searched)
    {
      std::vector<internal::Cut> cuts = m_search(m_memo[s].segment);
      internal::Sizes_of_parts(m_partition, default_options().weights, m_memo[s].segment)(cuts);
      m_memo.set_cuts(s, std::move(cuts));
    }
    return m_memo[s].cuts;
  }

  Indexed_surface m_surface;
  std::optional<internal::Any_distance> m_distance;
  internal::Graphs_of_surface m_graphs;
  internal::Segment_search m_search;
  internal::Segment_memo m_memo;
  internal::Graph_partition m_partition;
  Cut_set m_whole;
};

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_ALL_CUTS_H
