// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_SURFACE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// What becomes of a surface whose faces are cut: pieces of its faces, in their order. Vertices are those of the surface
// and, numbered behind them, new ones.
struct Cut_surface
{
  using Index = Indexed_surface::Index;
  using Weights = std::vector<std::pair<Index, double>>; // of vertices of the surface; their sum is 1

  using Border_lengths = std::map<std::pair<Index, Index>, double>;

  struct Piece
  {
    std::vector<Index> corners;
    Index face; // of the surface
    Index segment;
  };

  std::vector<Weights> new_vertices;
  std::vector<Piece> pieces;

  // Whether no two pieces have an edge in the same direction, as in any surface.
  bool is_surface() const
  {
    std::vector<std::pair<Index, Index>> edges;
    for (const Piece& piece : pieces)
      for (std::size_t i = 0; i < piece.corners.size(); ++i)
        edges.emplace_back(piece.corners[i], piece.corners[(i + 1) % piece.corners.size()]);
    std::sort(edges.begin(), edges.end());
    return std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  }

  // An edge between two pieces.
  struct Inner_edge
  {
    Index low, high; // its ends
    Index piece, other_piece;
  };

  std::vector<Inner_edge> inner_edges() const
  {
    std::vector<std::array<Index, 3>> edges; // two vertices, the lower one first, and a piece
    for (std::size_t p = 0; p < pieces.size(); ++p)
      for (std::size_t i = 0; i < pieces[p].corners.size(); ++i)
      {
        const auto [low, high] = std::minmax(pieces[p].corners[i],
                                             pieces[p].corners[(i + 1) % pieces[p].corners.size()]);
        edges.push_back({low, high, static_cast<Index>(p)});
      }
    std::sort(edges.begin(), edges.end());
    std::vector<Inner_edge> result;
    for (std::size_t i = 1; i < edges.size(); ++i)
      if (edges[i][0] == edges[i - 1][0] && edges[i][1] == edges[i - 1][1])
        result.push_back({edges[i][0], edges[i][1], edges[i - 1][2], edges[i][2]});
    return result;
  }

  using Parts = std::vector<std::vector<Index>>; // pieces, in their order

  // The connected sets of pieces of which each segment consists.
  std::vector<Parts> connected_parts(const std::vector<Inner_edge>& edges, std::size_t number_of_segments) const
  {
    Disjoint_sets sets(pieces.size());
    for (const Inner_edge& edge : edges)
      if (pieces[edge.piece].segment == pieces[edge.other_piece].segment)
        sets.union_set(edge.piece, edge.other_piece);
    std::vector<std::size_t> part_of(pieces.size(), 0); // one more than its number; of the representatives of sets
    std::vector<Parts> result(number_of_segments);
    for (Index p = 0; p < pieces.size(); ++p)
    {
      Parts& parts = result[pieces[p].segment];
      std::size_t& part = part_of[sets.find_set(p)];
      if (part == 0)
      {
        parts.emplace_back();
        part = parts.size();
      }
      parts[part - 1].push_back(p);
    }
    return result;
  }

  // The length of the border between any two segments, the lower one first.
  Border_lengths border_lengths(const std::vector<Inner_edge>& edges, const Indexed_surface& surface) const
  {
    Border_lengths result;
    for (const Inner_edge& edge : edges)
      if (const Index s = pieces[edge.piece].segment, t = pieces[edge.other_piece].segment; s != t)
        result[std::minmax(s, t)] +=
          std::sqrt((position(edge.low, surface) - position(edge.high, surface)).squared_length());
    return result;
  }

  // The place of a vertex, as seen from the origin.
  Indexed_surface::Vector_3 position(Index vertex, const Indexed_surface& surface) const
  {
    const Index n = surface.number_of_vertices();
    if (vertex < n)
      return surface.point(vertex) - CGAL::ORIGIN;
    Indexed_surface::Vector_3 sum(0, 0, 0);
    for (const auto& [old, weight] : new_vertices[vertex - n])
      sum = sum + weight * (surface.point(old) - CGAL::ORIGIN);
    return sum;
  }
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_SURFACE_H
