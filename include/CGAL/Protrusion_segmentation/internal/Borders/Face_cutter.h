// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_FACE_CUTTER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_FACE_CUTTER_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Cut_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Vertex_shares.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Cuts faces between vertices of different segments: marching triangles, for any number of segments and of corners.
//
// An edge between two segments is cut where their shares are equal. A face with two cut edges falls in two pieces, one with
// more in as many, around a new vertex in the middle. Faces of fixed segments stay whole, but get the new vertices on
// their edges.
class Face_cutter
{
public:
  using Index = Indexed_surface::Index;

  // The arguments must outlive the object. `is_fixed` is of segments.
  Face_cutter(const Indexed_surface& surface,
              const std::vector<Index>& segment_of_face,
              const std::vector<bool>& is_fixed,
              const Vertex_shares& shares)
    : m_surface(surface),
      m_segment_of_face(segment_of_face),
      m_is_fixed(is_fixed),
      m_shares(shares),
      m_segments(shares.segments())
  {}

  Cut_surface cut()
  {
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      if (!is_fixed(f))
        cut_edges(f);
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      cut_face(f);
    return std::move(m_result);
  }

private:
  using Corners = std::vector<Index>;

  bool is_fixed(Index f) const { return m_is_fixed[m_segment_of_face[f]]; }

  Corners corners(Index f) const
  {
    Corners result;
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
      result.push_back(m_surface.vertex(c));
    return result;
  }

  Index add_vertex(Cut_surface::Weights weights)
  {
    m_result.new_vertices.push_back(std::move(weights));
    return static_cast<Index>(m_surface.number_of_vertices() + m_result.new_vertices.size() - 1);
  }

  void cut_edges(Index f)
  {
    const Corners loop = corners(f);
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const auto [u, v] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
      if (m_segments[u] == m_segments[v] || m_cut_edges.count({u, v}) > 0)
        continue;
      const double share = share_of_cut(u, v);
      m_cut_edges[{u, v}] = add_vertex({{u, 1 - share}, {v, share}});
    }
  }

  // Where on the edge from `u` to `v` the shares of their segments are equal. Not too near to an end: pieces would be thin.
  double share_of_cut(Index u, Index v) const
  {
    constexpr double least_share = 0.05;
    const Index s = m_segments[u], t = m_segments[v];
    const double at_u = m_shares.share(u, s) - m_shares.share(u, t);
    const double at_v = m_shares.share(v, t) - m_shares.share(v, s);
    if (!(at_u + at_v > 0)) // both were given away as islands
      return 0.5;
    return std::clamp(at_u / (at_u + at_v), least_share, 1 - least_share);
  }

  void cut_face(Index f)
  {
    const Corners old = corners(f);
    Corners loop;
    std::vector<std::size_t> cuts; // where in the loop
    for (std::size_t i = 0; i < old.size(); ++i)
    {
      loop.push_back(old[i]);
      const auto edge = m_cut_edges.find(std::minmax(old[i], old[(i + 1) % old.size()]));
      if (edge == m_cut_edges.end())
        continue;
      cuts.push_back(loop.size());
      loop.push_back(edge->second);
    }
    if (is_fixed(f) && !cuts.empty() && old.size() == 3)
      add_fan(loop, f);
    else if (is_fixed(f) || cuts.empty())
      m_result.pieces.push_back({loop, f, is_fixed(f) ? m_segment_of_face[f] : m_segments[old.front()]});
    else
      add_pieces(loop, cuts, f);
  }

  void add_pieces(const Corners& loop, const std::vector<std::size_t>& cuts, Index f)
  {
    std::vector<Index> middle; // one vertex, or none
    if (cuts.size() > 2)
    {
      Corners new_ones;
      for (std::size_t cut : cuts)
        new_ones.push_back(loop[cut]);
      middle.push_back(add_mean(new_ones));
    }
    for (std::size_t i = 0; i < cuts.size(); ++i)
    {
      Corners piece;
      for (std::size_t c = cuts[i]; c != cuts[(i + 1) % cuts.size()]; c = (c + 1) % loop.size())
        piece.push_back(loop[c]);
      piece.push_back(loop[cuts[(i + 1) % cuts.size()]]);
      const Index segment = m_segments[piece[1]];
      piece.insert(piece.end(), middle.begin(), middle.end());
      add_piece(piece, f, segment);
    }
  }

  // Pieces of triangles are triangles.
  void add_piece(const Corners& piece, Index f, Index segment)
  {
    const bool is_of_triangle = m_surface.first_corner(f + 1) - m_surface.first_corner(f) == 3;
    if (!is_of_triangle || piece.size() != 4)
    {
      m_result.pieces.push_back({piece, f, segment});
      return;
    }
    const std::size_t first = squared_length(piece[0], piece[2]) <= squared_length(piece[1], piece[3]) ? 0 : 1;
    m_result.pieces.push_back({{piece[first], piece[first + 1], piece[first + 2]}, f, segment});
    m_result.pieces.push_back({{piece[first + 2], piece[(first + 3) % 4], piece[first]}, f, segment});
  }

  void add_fan(const Corners& loop, Index f)
  {
    const Index middle = add_mean(corners(f));
    for (std::size_t i = 0; i < loop.size(); ++i)
      m_result.pieces.push_back({{loop[i], loop[(i + 1) % loop.size()], middle}, f, m_segment_of_face[f]});
  }

  Index add_mean(const Corners& vertices)
  {
    Cut_surface::Weights weights;
    for (Index v : vertices)
      for (const auto& [old, weight] : weights_of(v))
        weights.emplace_back(old, weight / static_cast<double>(vertices.size()));
    return add_vertex(std::move(weights));
  }

  Cut_surface::Weights weights_of(Index v) const
  {
    const Index n = m_surface.number_of_vertices();
    return v < n ? Cut_surface::Weights{{v, 1.}} : m_result.new_vertices[v - n];
  }

  double squared_length(Index u, Index v) const
  {
    Indexed_surface::Vector_3 sum(0, 0, 0);
    for (const auto& [old, weight] : weights_of(u))
      sum = sum + weight * (m_surface.point(old) - CGAL::ORIGIN);
    for (const auto& [old, weight] : weights_of(v))
      sum = sum - weight * (m_surface.point(old) - CGAL::ORIGIN);
    return sum.squared_length();
  }

  const Indexed_surface& m_surface;
  const std::vector<Index>& m_segment_of_face;
  const std::vector<bool>& m_is_fixed;
  const Vertex_shares& m_shares;
  std::vector<Index> m_segments; // of the vertices
  std::map<std::pair<Index, Index>, Index> m_cut_edges; // the new vertex on an edge, the lower end first
  Cut_surface m_result;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_FACE_CUTTER_H
