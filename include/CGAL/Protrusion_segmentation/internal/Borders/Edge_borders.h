// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_EDGE_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_EDGE_BORDERS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The borders between segments as they are at first, along edges.
class Edge_borders
{
public:
  using Index = Indexed_surface::Index;
  using Pair = std::pair<Index, Index>; // of segments, the lower one first

  Edge_borders(const Indexed_surface& surface,
               const std::vector<Index>& segment_of_face,
               std::size_t number_of_segments)
    : m_neighbors(number_of_segments)
  {
    const std::vector<bool> is_junction = junctions(surface, segment_of_face);
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
        if (const Index g = surface.neighbor(c); g != Indexed_surface::no_face() && f < g &&
                                                 segment_of_face[f] != segment_of_face[g])
        {
          Border& border = m_borders[std::minmax(segment_of_face[f], segment_of_face[g])];
          border.length += surface.edge_length(f, c);
          for (Index v : {surface.vertex(c), surface.vertex(surface.next_corner(f, c))})
            if (is_junction[v])
              border.junctions.push_back(v);
        }
    for (const auto& [pair, border] : m_borders)
    {
      m_neighbors[pair.first].push_back(pair.second);
      m_neighbors[pair.second].push_back(pair.first);
    }
  }

  bool contains(const Pair& pair) const { return m_borders.count(pair) > 0; }
  double length(const Pair& pair) const { return m_borders.at(pair).length; }

  // Where it meets other borders.
  const std::vector<Index>& junctions_of(const Pair& pair) const { return m_borders.at(pair).junctions; }

  const std::vector<Index>& neighbors(Index segment) const { return m_neighbors[segment]; }

private:
  struct Border
  {
    double length = 0;
    std::vector<Index> junctions; // most of them twice or more
  };

  // The vertices where more than two borders end; each boundary of the surface there counts as one.
  static std::vector<bool> junctions(const Indexed_surface& surface, const std::vector<Index>& segment_of_face)
  {
    std::vector<Index> borders(surface.number_of_vertices(), 0); // that end at a vertex; the boundary of the surface is one
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
        if (const Index g = surface.neighbor(c); g == Indexed_surface::no_face())
          ++borders[surface.vertex(c)]; // a vertex has one such edge that begins, and one that ends in it
        else if (f < g && segment_of_face[f] != segment_of_face[g])
          for (Index v : {surface.vertex(c), surface.vertex(surface.next_corner(f, c))})
            ++borders[v];
    std::vector<bool> result;
    for (Index number : borders)
      result.push_back(number > 2);
    return result;
  }

  std::map<Pair, Border> m_borders;
  std::vector<std::vector<Index>> m_neighbors; // of each segment
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_EDGE_BORDERS_H
