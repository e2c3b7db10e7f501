// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_VERTEX_SHARES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_VERTEX_SHARES_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// By what share each vertex belongs to each segment: first by the angles of the faces around it, then averaged with its
// neighbors again and again. Where shares of two segments are equal, there is a smooth line between them.
//
// The average has the weights of mean value coordinates (M. S. Floater, 2003): positive, and exact for what is linear on
// the surface, so that the line does not drift to where edges are short. Faces of fixed segments do not exist here.
class Vertex_shares
{
public:
  using Index = Indexed_surface::Index;

  static constexpr Index no_segment() { return Indexed_surface::no_face(); }

  // The arguments must outlive the object. `is_fixed` is of segments.
  Vertex_shares(const Indexed_surface& surface,
                const std::vector<Index>& segment_of_face,
                const std::vector<bool>& is_fixed)
    : m_surface(surface), m_shares(surface.number_of_vertices()), m_is_in_band(surface.number_of_vertices(), false)
  {
    std::vector<Index> vertex_of_corner;
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      if (!is_fixed[segment_of_face[f]])
        add_corners(f, segment_of_face[f], vertex_of_corner);
    m_corners_of = Index_groups(vertex_of_corner, surface.number_of_vertices());
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

  double share(Index vertex, Index segment) const
  {
    for (const auto& [s, share] : m_shares[vertex])
      if (s == segment)
        return share;
    return 0;
  }

  // The segment of the largest share of each vertex; `no_segment()` for vertices of fixed segments only. A few vertices
  // that hang together, but not with any that lay in their segment from the beginning, go to a neighbor.
  std::vector<Index> segments() const
  {
    std::vector<Index> result;
    for (const Shares& shares : m_shares)
      result.push_back(shares.empty() ? no_segment() : segment_of(shares));
    give_islands_away(result);
    return result;
  }

private:
  using Shares = std::vector<std::pair<Index, double>>; // of segments, most often of one

  // A face at a vertex, and how much the ends of its two edges there count.
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

  // Of shares that differ by rounding only, as on a straight border, all vertices take that of the same segment.
  static Index segment_of(const Shares& shares)
  {
    constexpr double tie = 1e-9;
    auto best = shares.begin();
    for (auto share = shares.begin(); share != shares.end(); ++share)
      if (share->second > best->second + tie || (share->second > best->second - tie && share->first < best->first))
        best = share;
    return best->first;
  }

  void add_corners(Index f, Index segment, std::vector<Index>& vertex_of_corner)
  {
    constexpr double least_angle = 1e-6; // of faces without area
    constexpr double largest_angle = 3;  // at pi the weight would be infinite
    constexpr double least_length = 1e-12;
    const Index n = m_surface.first_corner(f + 1) - m_surface.first_corner(f);
    const auto vertex = [&](Index i) { return m_surface.vertex(m_surface.first_corner(f) + i % n); };
    for (Index i = 0; i < n; ++i)
    {
      const Index v = vertex(i), before = vertex(i + n - 1), after = vertex(i + 1);
      const auto to_before = m_surface.point(before) - m_surface.point(v);
      const auto to_after = m_surface.point(after) - m_surface.point(v);
      const double length_before = (std::max)(std::sqrt(to_before.squared_length()), least_length);
      const double length_after = (std::max)(std::sqrt(to_after.squared_length()), least_length);
      const double cosine = to_before * to_after / (length_before * length_after);
      const double angle = std::clamp(std::acos(std::clamp(cosine, -1., 1.)), least_angle, largest_angle);
      const double tangent = std::tan(angle / 2);
      vertex_of_corner.push_back(v);
      m_corners.push_back({before, after, tangent / length_before, tangent / length_after});
      add(m_shares[v], segment, angle);
    }
  }

  // Further away nothing changes.
  void make_band(std::size_t number_of_rounds)
  {
    for (Index v = 0; v < m_shares.size(); ++v)
      if (m_shares[v].size() > 1)
        add_to_band(v);
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

  void add_to_band(Index v)
  {
    if (m_is_in_band[v])
      return;
    m_is_in_band[v] = true;
    m_band.push_back(v);
  }

  // A vertex keeps some of its own shares: without, those of every other vertex of a grid would never mix.
  Shares average_around(Index v) const
  {
    constexpr double kept_share = 1. / 3;
    Shares result;
    const auto add_all = [&](Index neighbor, double weight)
    {
      for (const auto& [segment, share] : m_shares[neighbor])
        add(result, segment, weight * share);
    };
    for (Index c : m_corners_of[v])
    {
      add_all(m_corners[c].before, m_corners[c].weight_before);
      add_all(m_corners[c].after, m_corners[c].weight_after);
    }
    scale(result);
    for (auto& entry : result)
      entry.second *= 1 - kept_share;
    for (const auto& [segment, share] : m_shares[v])
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
          for (Index v : {m_corners[c].before, m_corners[c].after})
            if (segments[v] != segments[seed])
              ++edges_to[segments[v]];
            else if (!m_is_in_band[v])
              is_island = false;
            else if (!is_seen[v])
            {
              is_seen[v] = true;
              island.push_back(v);
            }
      }
      if (!is_island || edges_to.empty())
        continue;
      const Index most = std::max_element(edges_to.begin(), edges_to.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; })
                           ->first;
      for (Index v : island)
        segments[v] = most;
    }
  }

  const Indexed_surface& m_surface;
  std::vector<Shares> m_shares;    // of the vertices
  std::vector<Corner> m_corners;   // of faces that are not fixed
  Index_groups m_corners_of = Index_groups({}, 0); // of the vertices
  std::vector<Index> m_band;       // vertices whose shares may change, the mixed ones first
  std::vector<bool> m_is_in_band;
  std::size_t m_number_of_mixed = 0; // vertices that belong to several segments from the beginning
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_VERTEX_SHARES_H
