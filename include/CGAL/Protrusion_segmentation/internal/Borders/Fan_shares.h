// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_FAN_SHARES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_FAN_SHARES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Corner_fans.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// By what share each fan, most often all that is around a vertex, belongs to each segment: first by the angles of its faces,
// then averaged with its neighbors again and again. Where shares of two segments are equal, there is a smooth line between
// them.
//
// The average has the weights of mean value coordinates (M. S. Floater, 2003): positive, and exact for what is linear on
// the surface, so that the line does not drift to where edges are short.
class Fan_shares
{
public:
  using Index = Indexed_surface::Index;

  Fan_shares(const Indexed_surface& surface, const std::vector<Index>& segment_of_face, const Corner_fans& fans)
    : m_shares(fans.number_of_fans()),
      m_corners_of(fans.of_corners(), fans.number_of_fans()),
      m_is_in_band(fans.number_of_fans(), false)
  {
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      add_corners(surface, fans, f, segment_of_face[f]);
    for (Shares& shares : m_shares)
      scale(shares);
  }

  void smooth(std::size_t number_of_rounds)
  {
    make_band(number_of_rounds);
    std::vector<Shares> next(m_band.size());
    for (std::size_t round = 0; round < number_of_rounds; ++round)
    {
      for (std::size_t i = 0; i < m_band.size(); ++i)
        next[i] = average_around(m_band[i]);
      for (std::size_t i = 0; i < m_band.size(); ++i)
        m_shares[m_band[i]].swap(next[i]);
    }
  }

  double share(Index fan, Index segment) const
  {
    for (const auto& [s, share] : m_shares[fan])
      if (s == segment)
        return share;
    return 0;
  }

  // The segment of the largest share of each fan. An island of connected fans, none of which lay in their segment alone from the
  // beginning, gets the segment of a neighbor.
  std::vector<Index> segments() const
  {
    std::vector<Index> result;
    for (const Shares& shares : m_shares)
      result.push_back(segment_of(shares));
    give_islands_away(result);
    return result;
  }

private:
  using Shares = std::vector<std::pair<Index, double>>; // of segments, most often of one

  // A face of a fan, and how much the fans at the ends of its two edges there count.
  struct Corner
  {
    Index before, after;
    double weight_before, weight_after;
  };

  static void add(Shares& shares, Index segment, double share)
  {
    for (auto& [s, sum] : shares)
      if (s == segment)
      {
        sum += share;
        return;
      }
    shares.emplace_back(segment, share);
  }

  static void scale(Shares& shares)
  {
    double sum = 0;
    for (const auto& entry : shares)
      sum += entry.second;
    for (auto& entry : shares)
      entry.second /= sum;
  }

  // Of shares that differ by rounding only, as on a straight border, all fans take that of the same segment.
  static Index segment_of(const Shares& shares)
  {
    constexpr double tie = 1e-9;
    auto best = shares.begin();
    for (auto share = shares.begin(); share != shares.end(); ++share)
      if (share->second > best->second + tie || (share->second > best->second - tie && share->first < best->first))
        best = share;
    return best->first;
  }

  void add_corners(const Indexed_surface& surface, const Corner_fans& fans, Index f, Index segment)
  {
    constexpr double least_angle = 1e-6; // of faces without area
    constexpr double largest_angle = 3;  // at pi the weight would be infinite
    constexpr double least_length = 1e-12;
    const Index first = surface.first_corner(f), n = surface.first_corner(f + 1) - first;
    const auto point = [&](Index corner) { return surface.point(surface.vertex(corner)); };
    for (Index i = 0; i < n; ++i)
    {
      const Index corner = first + i, before = first + (i + n - 1) % n, after = first + (i + 1) % n;
      const auto to_before = point(before) - point(corner);
      const auto to_after = point(after) - point(corner);
      const double length_before = (std::max)(std::sqrt(to_before.squared_length()), least_length);
      const double length_after = (std::max)(std::sqrt(to_after.squared_length()), least_length);
      const double cosine = to_before * to_after / (length_before * length_after);
      const double angle = std::clamp(std::acos(std::clamp(cosine, -1., 1.)), least_angle, largest_angle);
      const double tangent = std::tan(angle / 2);
      m_corners.push_back({fans[before], fans[after], tangent / length_before, tangent / length_after});
      add(m_shares[fans[corner]], segment, angle);
    }
  }

  // The fans whose shares can change.
  void make_band(std::size_t number_of_rounds)
  {
    for (Index fan = 0; fan < m_shares.size(); ++fan)
      if (m_shares[fan].size() > 1)
        add_to_band(fan);
    m_number_of_mixed = m_band.size();
    std::size_t first = 0;
    for (std::size_t round = 0; round < number_of_rounds; ++round)
      for (const std::size_t end = m_band.size(); first < end; ++first)
        for (Index c : m_corners_of[m_band[first]])
        {
          add_to_band(m_corners[c].before);
          add_to_band(m_corners[c].after);
        }
  }

  void add_to_band(Index fan)
  {
    if (m_is_in_band[fan])
      return;
    m_is_in_band[fan] = true;
    m_band.push_back(fan);
  }

  // A fan keeps some of its own shares: without, those of every other vertex of a grid would never mix.
  Shares average_around(Index fan) const
  {
    constexpr double kept_share = 1. / 3;
    Shares result;
    const auto add_all = [&](Index neighbor, double weight)
    {
      for (const auto& [segment, share] : m_shares[neighbor])
        add(result, segment, weight * share);
    };
    for (Index c : m_corners_of[fan])
    {
      add_all(m_corners[c].before, m_corners[c].weight_before);
      add_all(m_corners[c].after, m_corners[c].weight_after);
    }
    scale(result);
    for (auto& entry : result)
      entry.second *= 1 - kept_share;
    for (const auto& [segment, share] : m_shares[fan])
      add(result, segment, kept_share * share);
    return result;
  }

  void give_islands_away(std::vector<Index>& segments) const
  {
    std::vector<bool> was_mixed(segments.size(), false), is_seen(segments.size(), false);
    for (std::size_t i = 0; i < m_number_of_mixed; ++i)
      was_mixed[m_band[i]] = true;
    for (Index seed : m_band)
    {
      if (is_seen[seed])
        continue;
      std::vector<Index> island(1, seed);
      std::map<Index, std::size_t> edges_to; // other segments
      bool is_island = true;
      is_seen[seed] = true;
      for (std::size_t i = 0; i < island.size(); ++i)
      {
        is_island = is_island && was_mixed[island[i]];
        for (Index c : m_corners_of[island[i]])
          for (Index fan : {m_corners[c].before, m_corners[c].after})
            if (segments[fan] != segments[seed])
              ++edges_to[segments[fan]];
            else if (!m_is_in_band[fan])
              is_island = false;
            else if (!is_seen[fan])
            {
              is_seen[fan] = true;
              island.push_back(fan);
            }
      }
      if (!is_island || edges_to.empty())
        continue;
      const Index most = std::max_element(edges_to.begin(), edges_to.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; })
                           ->first;
      for (Index fan : island)
        segments[fan] = most;
    }
  }

  std::vector<Shares> m_shares;  // of the fans
  std::vector<Corner> m_corners; // of the surface
  Index_groups m_corners_of;     // of the fans
  std::vector<Index> m_band;     // fans whose shares may change, the mixed ones first
  std::vector<bool> m_is_in_band;
  std::size_t m_number_of_mixed = 0; // fans that belong to several segments from the beginning
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_FAN_SHARES_H
