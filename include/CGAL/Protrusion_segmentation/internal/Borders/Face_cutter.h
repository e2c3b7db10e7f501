// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_FACE_CUTTER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_FACE_CUTTER_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Corner_fans.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Cut_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Fan_shares.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Cuts faces between corners of different segments: marching triangles, for any number of segments and of corners.
//
// An edge between two segments is cut where their shares are equal. A face with two cut edges falls in two pieces, one with
// more in as many, around a new vertex in the middle. A line may end at a kept border: then the face on its other side gets
// the new vertex, too.
class Face_cutter
{
public:
  using Index = Indexed_surface::Index;

  // The arguments must outlive the object.
  Face_cutter(const Indexed_surface& surface, const Corner_fans& fans, const Fan_shares& shares)
    : m_surface(surface), m_fans(fans), m_shares(shares), m_segments(shares.segments())
  {}

  Cut_surface cut()
  {
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      cut_edges(f);
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      cut_face(f);
    return std::move(m_result);
  }

private:
  using Corners = std::vector<Index>;

  // A corner of a face, or a new vertex on an edge, which is in no segment.
  struct Loop_vertex
  {
    Index vertex, segment;
  };

  static constexpr Index no_segment() { return Indexed_surface::no_face(); }

  Index segment(Index corner) const { return m_segments[m_fans[corner]]; }

  Index add_vertex(Cut_surface::Weights weights)
  {
    m_result.new_vertices.push_back(std::move(weights));
    return static_cast<Index>(m_surface.number_of_vertices() + m_result.new_vertices.size() - 1);
  }

  void cut_edges(Index f)
  {
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
    {
      Index from = c, to = m_surface.next_corner(f, c);
      if (segment(from) == segment(to))
        continue;
      if (m_surface.vertex(from) > m_surface.vertex(to))
        std::swap(from, to);
      const Index u = m_surface.vertex(from), v = m_surface.vertex(to);
      const double share = share_of_cut(m_fans[from], m_fans[to]);
      const auto [cut, is_new] = m_cut_edges.emplace(std::make_pair(u, v), Index(0));
      if (is_new)
        cut->second = add_vertex({{u, 1 - share}, {v, share}});
      else
        move_to_mean(m_result.new_vertices[cut->second - m_surface.number_of_vertices()], share);
    }
  }

  // On a kept border, lines may come to an edge from both sides, at different places.
  static void move_to_mean(Cut_surface::Weights& weights, double share)
  {
    weights[1].second = (weights[1].second + share) / 2;
    weights[0].second = 1 - weights[1].second;
  }

  // Where on the edge between two fans the shares of their segments are equal. Not too near to an end: pieces would be thin.
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

  std::vector<Loop_vertex> loop_with_cuts(Index f) const
  {
    std::vector<Loop_vertex> loop;
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
    {
      const Index v = m_surface.vertex(c), next = m_surface.vertex(m_surface.next_corner(f, c));
      loop.push_back({v, segment(c)});
      if (const auto cut = m_cut_edges.find(std::minmax(v, next)); cut != m_cut_edges.end())
        loop.push_back({cut->second, no_segment()});
    }
    return loop;
  }

  void cut_face(Index f)
  {
    const std::vector<Loop_vertex> loop = loop_with_cuts(f);
    std::vector<std::size_t> cuts; // where in the loop it goes from one segment to another
    for (std::size_t i = 1; i < loop.size(); ++i)
      if (loop[i].segment == no_segment() && loop[i - 1].segment != loop[(i + 1) % loop.size()].segment)
        cuts.push_back(i);
    if (!cuts.empty())
      return add_pieces(loop, cuts, f);
    Corners corners;
    for (const Loop_vertex& v : loop)
      corners.push_back(v.vertex);
    add_piece(corners, f, loop.front().segment);
  }

  void add_pieces(const std::vector<Loop_vertex>& loop, const std::vector<std::size_t>& cuts, Index f)
  {
    Corners middle; // one vertex, or none
    if (cuts.size() > 2)
    {
      Corners new_ones;
      for (std::size_t cut : cuts)
        new_ones.push_back(loop[cut].vertex);
      middle.push_back(add_mean(new_ones));
    }
    for (std::size_t i = 0; i < cuts.size(); ++i)
    {
      Corners piece;
      const std::size_t last = cuts[(i + 1) % cuts.size()];
      for (std::size_t c = cuts[i]; c != last; c = (c + 1) % loop.size())
        piece.push_back(loop[c].vertex);
      piece.push_back(loop[last].vertex);
      piece.insert(piece.end(), middle.begin(), middle.end());
      add_piece(piece, f, loop[(cuts[i] + 1) % loop.size()].segment);
    }
  }

  // Pieces of triangles are triangles. One with more than four corners has a corner in a straight side.
  void add_piece(const Corners& piece, Index f, Index segment)
  {
    const bool is_of_triangle = m_surface.first_corner(f + 1) - m_surface.first_corner(f) == 3;
    if (!is_of_triangle || piece.size() == 3)
      m_result.pieces.push_back({piece, f, segment});
    else if (piece.size() == 4 && piece.front() >= m_surface.number_of_vertices())
      add_halves(piece, f, segment);
    else
      add_fan(piece, f, segment);
  }

  void add_halves(const Corners& piece, Index f, Index segment)
  {
    const std::size_t first = squared_length(piece[0], piece[2]) <= squared_length(piece[1], piece[3]) ? 0 : 1;
    m_result.pieces.push_back({{piece[first], piece[first + 1], piece[first + 2]}, f, segment});
    m_result.pieces.push_back({{piece[first + 2], piece[(first + 3) % 4], piece[first]}, f, segment});
  }

  void add_fan(const Corners& piece, Index f, Index segment)
  {
    const Index middle = add_mean(piece);
    for (std::size_t i = 0; i < piece.size(); ++i)
      m_result.pieces.push_back({{piece[i], piece[(i + 1) % piece.size()], middle}, f, segment});
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
    return (m_result.position(u, m_surface) - m_result.position(v, m_surface)).squared_length();
  }

  const Indexed_surface& m_surface;
  const Corner_fans& m_fans;
  const Fan_shares& m_shares;
  std::vector<Index> m_segments;                       // of the fans
  std::map<std::pair<Index, Index>, Index> m_cut_edges; // the new vertex on an edge, the lower end first
  Cut_surface m_result;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_FACE_CUTTER_H
