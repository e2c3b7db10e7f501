// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_ALONG_SMOOTH_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_ALONG_SMOOTH_BORDERS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Corner_fans.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Cut_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Face_cutter.h>
#include <CGAL/Protrusion_segmentation/internal/Borders/Fan_shares.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

struct Smooth_borders
{
  Cut_surface surface;
  std::size_t number_of_fixed_segments = 0; // that would have been torn or lost, and keep their faces
};

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
      m_parts(number_of_segments, 0)
  {
    m_kept.of_segment.assign(number_of_segments, number_of_rounds == 0);
    for (Index label : label_components(surface, segment_of_face).label)
      ++m_parts[label];
    measure_borders();
  }

  Smooth_borders smooth()
  {
    for (;;)
    {
      Cut_surface result = cut();
      const Inner_edges edges = result.inner_edges();
      if (keep_torn_segments(result, edges) || keep_longer_borders(result, edges))
        continue;
      const auto number = std::count(m_kept.of_segment.begin(), m_kept.of_segment.end(), true);
      return {std::move(result), static_cast<std::size_t>(number)};
    }
  }

private:
  using Inner_edges = std::vector<Cut_surface::Inner_edge>;

  void measure_borders()
  {
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
        if (const Index g = m_surface.neighbor(c);
            g != Indexed_surface::no_face() && f < g && m_segment_of_face[f] != m_segment_of_face[g])
          m_lengths[std::minmax(m_segment_of_face[f], m_segment_of_face[g])] += m_surface.edge_length(f, c);
  }

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
    const std::vector<std::size_t> parts = result.connected_parts(edges, m_parts.size());
    bool is_any_new = false;
    for (std::size_t s = 0; s < m_parts.size(); ++s)
      if (!m_kept.of_segment[s] && (parts[s] != m_parts[s] || !is_surface))
        is_any_new = m_kept.of_segment[s] = true;
    return is_any_new;
  }

  // What smoothing does not shorten was straight before, along edges of the mesh.
  bool keep_longer_borders(const Cut_surface& result, const Inner_edges& edges)
  {
    constexpr double rounding = 1e-9; // relative
    bool is_any_new = false;
    for (const auto& [segments, length] : result.border_lengths(edges, m_surface))
      if (const auto old = m_lengths.find(segments);
          old != m_lengths.end() && !m_kept.contains(segments.first, segments.second) &&
          length > (1 - rounding) * old->second)
        is_any_new = m_kept.between.insert(segments).second;
    return is_any_new;
  }

  const Indexed_surface& m_surface;
  const std::vector<Index>& m_segment_of_face;
  const std::size_t m_number_of_rounds;
  std::vector<std::size_t> m_parts;     // of each segment, connected ones
  Cut_surface::Border_lengths m_lengths; // along edges
  Kept_borders m_kept;
};

// Moves the borders between segments to smooth lines, along which faces are cut. A border that would not get shorter stays
// where it is. A segment that does not come out in as many connected parts as it had keeps its faces.
inline Smooth_borders cut_along_smooth_borders(const Indexed_surface& surface,
                                               const std::vector<Indexed_surface::Index>& segment_of_face,
                                               std::size_t number_of_segments,
                                               std::size_t number_of_rounds)
{
  return Border_smoother(surface, segment_of_face, number_of_segments, number_of_rounds).smooth();
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_BORDERS_CUT_ALONG_SMOOTH_BORDERS_H
