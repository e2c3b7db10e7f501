// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_BORDERS_OF_CUTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_BORDERS_OF_CUTS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Segment_tree.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The segments on the two sides of a cut, in the end.
struct Sides_of_cut
{
  std::vector<Indexed_surface::Index> inner, outer;
};

// Finds of every cut the border where it runs in the end. The borders are a tree: each joins neighbours, and whatever is
// given back in a hierarchy is connected.
//
// That is the longest border between segments on the two sides of the cut, or, where other borders have moved in between,
// so that the sides touch no more, the longest one between segments not connected yet. But an arm that was cut off together
// with the head sticks out of the trunk, if that is what it has its longest border with. So in the end these are the
// longest borders that keep all segments together: a longer one takes the place, and the cut, of the shortest one that it
// makes superfluous.
class Borders_of_cuts
{
public:
  using Index = Indexed_surface::Index;
  using Border = Segment_tree::Border;
  using Lengths = std::map<Border, double>; // of all borders, each with its lower segment first

  // The lengths must outlive the object. `cuts`: in the order in which they were made, one less than segments.
  Borders_of_cuts(const Lengths& lengths, const std::vector<Sides_of_cut>& cuts)
    : m_number_of_segments(cuts.size() + 1), m_lengths(lengths), m_borders(cuts.size())
  {
    CGAL_precondition(lengths.size() >= cuts.size()); // the surface is connected
    take_longest_of_cuts(cuts);
    take_longest_of_all();
  }

  const std::vector<Border>& operator()() const { return m_borders; }

private:
  enum Side { NONE, INNER, OUTER };

  void take_longest_of_cuts(const std::vector<Sides_of_cut>& cuts)
  {
    Disjoint_sets joined(m_number_of_segments); // by the borders found so far
    std::vector<std::size_t> without_border;
    for (std::size_t c = cuts.size(); c-- > 0;)
    {
      std::vector<Side> side(m_number_of_segments, NONE);
      for (Index s : cuts[c].inner)
        side[s] = INNER;
      for (Index s : cuts[c].outer)
        side[s] = OUTER;
      const auto longest = longest_border([&](const Border& b)
                                          { return side[b.first] + side[b.second] == INNER + OUTER &&
                                                   side[b.first] != NONE && side[b.second] != NONE; });
      if (longest)
        take(*longest, c, joined);
      else
        without_border.push_back(c);
    }
    for (std::size_t c : without_border)
    {
      const auto longest = longest_border([&](const Border& b)
                                          { return joined.find_set(b.first) != joined.find_set(b.second); });
      CGAL_assertion(longest.has_value()); // the surface is connected
      take(*longest, c, joined);
    }
  }

  template <typename Accept>
  std::optional<Border> longest_border(Accept accept) const
  {
    std::optional<Border> longest;
    for (const auto& [border, length] : m_lengths)
      if (accept(border) && (!longest || length > m_lengths.at(*longest)))
        longest = border;
    return longest;
  }

  void take(const Border& border, std::size_t cut, Disjoint_sets& joined)
  {
    m_borders[cut] = border;
    joined.union_set(border.first, border.second);
  }

  // Kruskal's algorithm. Of borders of the same length those that are taken already come first.
  void take_longest_of_all()
  {
    std::vector<std::pair<double, Border>> longest_first;
    const auto is_taken = [&](const Border& b) { return std::find(m_borders.begin(), m_borders.end(), b) != m_borders.end(); };
    for (bool taken : {true, false})
      for (const auto& [border, length] : m_lengths)
        if (is_taken(border) == taken)
          longest_first.emplace_back(length, border);
    std::stable_sort(longest_first.begin(), longest_first.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    Disjoint_sets joined(m_number_of_segments); // by borders that stay
    for (const auto& [length, border] : longest_first)
    {
      if (joined.find_set(border.first) == joined.find_set(border.second))
        continue;
      if (!is_taken(border))
        m_borders[shortest_between(border.first, border.second, joined)] = border;
      joined.union_set(border.first, border.second);
    }
  }

  // The cut with the shortest border on the way from one segment to another one, through borders that need not stay: the
  // others connect what are the same sets already. Of equally short ones the last cut.
  std::size_t shortest_between(Index from, Index to, Disjoint_sets& joined) const
  {
    std::vector<std::optional<std::size_t>> cut_towards_from(m_number_of_segments);
    std::vector<Index> next_towards_from(m_number_of_segments, from), reached(1, from);
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (std::size_t c = 0; c < m_borders.size(); ++c)
        if (m_borders[c].first == reached[i] || m_borders[c].second == reached[i])
        {
          const Index s = m_borders[c].first == reached[i] ? m_borders[c].second : m_borders[c].first;
          if (s == from || cut_towards_from[s])
            continue;
          cut_towards_from[s] = c;
          next_towards_from[s] = reached[i];
          reached.push_back(s);
        }
    std::optional<std::size_t> shortest;
    for (Index s = to; s != from; s = next_towards_from[s])
    {
      const std::size_t c = *cut_towards_from[s];
      if (joined.find_set(m_borders[c].first) == joined.find_set(m_borders[c].second))
        continue; // it stays
      const auto order = [&](std::size_t cut) { return std::make_pair(-m_lengths.at(m_borders[cut]), cut); };
      if (!shortest || order(c) > order(*shortest))
        shortest = c;
    }
    CGAL_assertion(shortest.has_value()); // else the two were joined
    return *shortest;
  }

  std::size_t m_number_of_segments;
  const Lengths& m_lengths;
  std::vector<Border> m_borders; // of every cut
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_BORDERS_OF_CUTS_H
