// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_SURFACE_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// What becomes of a surface whose faces are cut: pieces of its faces, in their order. Vertices are those of the surface
// and, numbered behind them, new ones.
struct Cut_surface
{
  using Index = Indexed_surface::Index;
  using Weights = std::vector<std::pair<Index, double>>; // of vertices of the surface; their sum is 1

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

  // Of how many connected sets of pieces each segment consists.
  std::vector<std::size_t> connected_parts(std::size_t number_of_segments) const
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
    std::vector<std::size_t> parents(pieces.size()); // in a forest, a tree for each connected set
    std::iota(parents.begin(), parents.end(), std::size_t(0));
    const auto root = [&](std::size_t p)
    {
      while (parents[p] != p)
        p = parents[p] = parents[parents[p]];
      return p;
    };
    for (std::size_t i = 1; i < edges.size(); ++i)
      if (edges[i][0] == edges[i - 1][0] && edges[i][1] == edges[i - 1][1] &&
          pieces[edges[i][2]].segment == pieces[edges[i - 1][2]].segment)
        parents[root(edges[i][2])] = root(edges[i - 1][2]);
    std::vector<std::size_t> result(number_of_segments, 0);
    for (std::size_t p = 0; p < pieces.size(); ++p)
      result[pieces[p].segment] += parents[p] == p ? 1 : 0;
    return result;
  }
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_SURFACE_H
