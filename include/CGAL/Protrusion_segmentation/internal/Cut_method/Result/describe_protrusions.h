// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_DESCRIBE_PROTRUSIONS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_DESCRIBE_PROTRUSIONS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Protrusion.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut_weights.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Border_arcs.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Component_segments.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Tells of the protrusions of a connected surface: all of its segments but the body. The tip is the face of a segment that is
// farthest from the border to its parent.
class Protrusion_describer
{
public:
  using Index = Indexed_surface::Index;

  Protrusion_describer(const Indexed_surface& surface,
                       const Seam_graph& faces,
                       const Component_segments& segments,
                       bool is_parallel)
    : m_segments(segments),
      m_labels(segments.labels()),
      m_faces(faces),
      m_unit(std::sqrt(surface.area())), // there is no border without area
      m_borders(faces, segments.labels(), is_parallel)
  {}

  std::vector<Protrusion<Index>> operator()() const
  {
    std::vector<Protrusion<Index>> result;
    const std::vector<double> border_lengths = this->border_lengths();
    for (std::size_t s = 1; s < m_segments.number_of_segments(); ++s)
      result.push_back(describe(s, border_lengths[s]));
    find_tips(result);
    return result;
  }

private:
  Protrusion<Index> describe(std::size_t s, double border_length) const
  {
    Protrusion<Index> result;
    result.segment = s;
    result.parent = m_segments.parents()[s];
    result.value = m_segments.cut(s)->value;
    result.probability = probability_of_border(m_segments.cut(s)->log_odds);
    result.area = m_segments.areas_beyond()[s] * m_unit * m_unit;
    result.border_length = border_length * m_unit;
    return result;
  }

  // All at once: paths stay in the segment that they begin in.
  void find_tips(std::vector<Protrusion<Index>>& protrusions) const
  {
    const Nodes_by_distance nodes = Graph_distances(m_faces)(
      faces_along_borders(), [this](Index from, Index to) { return m_labels[from] == m_labels[to]; }, m_faces.lengths());
    for (std::size_t i = 0; i < nodes.nodes.size(); ++i) // the last one of a segment is the farthest
    {
      Protrusion<Index>& protrusion = protrusions[m_labels[nodes.nodes[i]] - 1];
      protrusion.tip = nodes.nodes[i];
      protrusion.border_distance = nodes.distances[i] * m_unit;
    }
  }

  // Of every segment but the body the faces at the border to its parent; its first face if it does not touch that, since
  // other borders moved in between.
  Nodes faces_along_borders() const
  {
    Nodes result;
    std::vector<bool> has_border(m_segments.number_of_segments(), false);
    has_border[0] = true;
    for (const Border_arcs::Arc& arc : m_borders.arcs())
    {
      const Index s = m_labels[arc.source];
      if (s == 0 || m_labels[arc.target] != m_segments.parents()[s] || (!result.empty() && result.back() == arc.source))
        continue;
      result.push_back(arc.source);
      has_border[s] = true;
    }
    for (std::size_t s = 0; s < has_border.size(); ++s)
      if (!has_border[s])
        result.push_back(static_cast<Index>(std::find(m_labels.begin(), m_labels.end(), s) - m_labels.begin()));
    return result;
  }

  // of every segment, between what lies beyond its border and the rest
  std::vector<double> border_lengths() const
  {
    std::vector<double> result(m_segments.number_of_segments(), 0);
    for (const Border_arcs::Arc& arc : m_borders.arcs())
      for (Index s = m_labels[arc.source]; !lies_beyond(m_labels[arc.target], s); s = m_segments.parents()[s])
        result[s] += arc.length;
    return result;
  }

  // Whether a segment is another one or sticks out of it, directly or not.
  bool lies_beyond(Index segment, Index other) const
  {
    while (segment != other && segment != 0)
      segment = m_segments.parents()[segment];
    return segment == other;
  }

  const Component_segments& m_segments;
  const std::vector<Index>& m_labels;
  const Seam_graph& m_faces;
  double m_unit;
  Border_arcs m_borders;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_DESCRIBE_PROTRUSIONS_H
