// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_BORDER_SMOOTHER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_BORDER_SMOOTHER_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Corner_fans.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Cut_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Edge_borders.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Face_cutter.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Fan_shares.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

struct Smooth_borders
{
  Cut_surface surface;
  std::size_t number_of_fixed_segments = 0; // that would have been torn or lost, and keep their faces
};

// Moves the borders between segments to smooth lines, along which faces are cut. No border gets longer, and there is none
// between segments that had none: borders that would become so stay where they are. A segment that does not come out in as many
// connected parts as it had keeps its faces.
class Border_smoother
{
public:
  using Index = Indexed_surface::Index;

  // The arguments must outlive the object.
  Border_smoother(const Indexed_surface& surface,
                  const std::vector<Index>& segment_of_face,
                  std::size_t number_of_segments,
                  std::size_t number_of_rounds)
    : m_surface(surface),
      m_segment_of_face(segment_of_face),
      m_number_of_rounds(number_of_rounds),
      m_parts(number_of_segments, 0),
      m_borders(surface, segment_of_face, number_of_segments)
  {
    for (Index label : label_components(surface, segment_of_face).label)
      ++m_parts[label];
    if (number_of_rounds == 0)
      for (Index s = 0; s < number_of_segments; ++s)
        m_kept.keep_segment(s);
  }

  Smooth_borders smooth()
  {
    for (;;)
    {
      Cut_surface result = cut();
      const Inner_edges edges = result.inner_edges();
      if (keep_torn_segments(result, edges) || keep_worse_borders(result, edges))
        continue;
      return {std::move(result), m_kept.number_of_segments()};
    }
  }

private:
  using Inner_edges = std::vector<Cut_surface::Inner_edge>;
  using Pair = Edge_borders::Pair;
  using New_contacts = std::map<Pair, std::vector<Index>>;

  static constexpr std::size_t number_of_steps = 5;
  static constexpr std::size_t number_of_scrap_steps = 3; // on real meshes more did not save another segment

  Cut_surface cut() const
  {
    const Corner_fans fans(m_surface, m_segment_of_face, m_kept);
    Fan_shares shares(m_surface, m_segment_of_face, fans);
    shares.smooth(m_number_of_rounds);
    return Face_cutter(m_surface, fans, shares).cut();
  }

  bool keep_torn_segments(const Cut_surface& result, const Inner_edges& edges)
  {
    const bool is_surface = result.is_surface();
    const std::vector<Cut_surface::Parts> parts = result.connected_parts(edges, m_parts.size());
    bool is_any_new = false;
    for (Index s = 0; s < m_parts.size(); ++s)
      if (parts[s].size() != m_parts[s] || !is_surface)
        is_any_new = keep_around_scraps(result, parts[s], s) || m_kept.keep_segment(s) || is_any_new;
    return is_any_new;
  }

  // Where a few edges of a border are kept, others may cut off a scrap beside them. Then its surroundings are kept, not all of
  // the segment.
  bool keep_around_scraps(const Cut_surface& result, const Cut_surface::Parts& parts, Index s)
  {
    if (parts.size() <= m_parts[s] || m_kept.contains_segment(s) || m_scrap_steps[s]++ >= number_of_scrap_steps)
      return false;
    std::vector<std::size_t> sizes;
    for (const auto& part : parts)
      sizes.push_back(part.size());
    std::sort(sizes.begin(), sizes.end());
    std::vector<Index> vertices;
    for (const auto& part : parts)
      if (part.size() <= sizes[parts.size() - m_parts[s] - 1])
        for (Index piece : part)
          add_corners(result.pieces[piece].face, vertices);
    return keep_at_vertices(vertices);
  }

  void add_corners(Index f, std::vector<Index>& vertices) const
  {
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
      vertices.push_back(m_surface.vertex(c));
  }

  // Keeps more around borders that got longer and between segments that did not touch before. A border that smoothing does not
  // shorten was straight before, along edges of the mesh.
  bool keep_worse_borders(const Cut_surface& result, const Inner_edges& edges)
  {
    constexpr double rounding = 1e-9; // relative
    const New_contacts contacts = new_contacts(result, edges);
    bool is_any_new = false;
    for (const auto& [pair, length] : result.border_lengths(edges, m_surface))
    {
      const double tolerance = m_kept.contains(pair.first, pair.second) ? rounding : -rounding;
      if (!m_borders.contains(pair) || length > (1 + tolerance) * m_borders.length(pair))
        is_any_new = keep_more(pair, contacts) || is_any_new;
    }
    return is_any_new;
  }

  // The vertices of the faces in which segments touch that did not.
  New_contacts new_contacts(const Cut_surface& result, const Inner_edges& edges) const
  {
    New_contacts contacts;
    for (const auto& edge : edges)
    {
      const Cut_surface::Piece &piece = result.pieces[edge.piece], &other = result.pieces[edge.other_piece];
      const Pair pair = std::minmax(piece.segment, other.segment);
      if (pair.first == pair.second || m_borders.contains(pair))
        continue;
      for (Index f : {piece.face, other.face})
        add_corners(f, contacts[pair]);
    }
    return contacts;
  }

  // Keeps more around a border each time that it is worse than before, in the end everything. Returns whether anything new is
  // kept.
  bool keep_more(const Pair& pair, const New_contacts& contacts)
  {
    std::size_t& step = m_steps[pair];
    while (step < number_of_steps)
      if (keep_at_step(step++, pair, contacts))
        return true;
    return false;
  }

  bool keep_at_step(std::size_t step, const Pair& pair, const New_contacts& contacts)
  {
    const auto [s, t] = pair;
    const bool is_old = m_borders.contains(pair);
    switch (step)
    {
    case 0: return is_old ? m_kept.keep_between(s, t) : keep_at_vertices(contacts.at(pair));
    case 1: return is_old && keep_at_vertices(m_borders.junctions_of(pair));
    case 2: return keep_to_common_neighbors(s, t);
    case 3: return keep_to_neighbors(std::array{s, t});
    default: return keep_to_neighbors(boost::irange(Index(0), Index(m_parts.size())));
    }
  }

  bool keep_at_vertices(const std::vector<Index>& vertices)
  {
    bool is_any_new = false;
    for (Index v : vertices)
      is_any_new = m_kept.keep_at_vertex(v) || is_any_new;
    return is_any_new;
  }

  // Of both segments with each segment that touches both.
  bool keep_to_common_neighbors(Index s, Index t)
  {
    bool is_any_new = false;
    for (Index neighbor : m_borders.neighbors(s))
      if (m_borders.contains(std::minmax(neighbor, t)))
        for (Index segment : {s, t})
          is_any_new = m_kept.keep_between(segment, neighbor) || is_any_new;
    return is_any_new;
  }

  template <typename Segments>
  bool keep_to_neighbors(const Segments& segments)
  {
    bool is_any_new = false;
    for (Index s : segments)
      for (Index neighbor : m_borders.neighbors(s))
        is_any_new = m_kept.keep_between(s, neighbor) || is_any_new;
    return is_any_new;
  }

  const Indexed_surface& m_surface;
  const std::vector<Index>& m_segment_of_face;
  const std::size_t m_number_of_rounds;
  std::vector<std::size_t> m_parts; // of each segment, connected ones
  std::map<Index, std::size_t> m_scrap_steps; // how often something was kept around scraps of a segment
  Edge_borders m_borders;
  Kept_borders m_kept;
  std::map<Pair, std::size_t> m_steps; // how often more was kept around a border
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_BORDER_SMOOTHER_H
