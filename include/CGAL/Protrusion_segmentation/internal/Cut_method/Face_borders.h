// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_FACE_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_FACE_BORDERS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/level_set_cuts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/minimum_cut.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Brings a segmentation of the coarse graph to the faces: there, the border between any two neighbouring segments
// becomes the minimum cut in a narrow band around it.
class Face_borders
{
public:
  using Index = Weighted_dual_graph::Index;
  using Nodes = Graph_partition::Nodes;

  // `labels`: the segment of every face, each of them connected
  Face_borders(const Weighted_dual_graph& graph, std::vector<Index> labels, std::size_t number_of_segments)
    : m_partition(graph, std::move(labels)),
      m_faces(number_of_segments),
      m_number(graph.number_of_nodes(), Indexed_surface::no_face())
  {
    for (Index f = 0; f < graph.number_of_nodes(); ++f)
      m_faces[m_partition.segment(f)].push_back(f);
  }

  void refine(Execution& execution)
  {
    constexpr int number_of_rounds = 2; // a border may change where another one meets it
    for (int round = 0; round < number_of_rounds; ++round)
      for (const auto& [s, t] : neighbors())
      {
        execution.check();
        refine(s, t);
      }
  }

  // the segment of every face
  const std::vector<Index>& labels() const { return m_partition.segments(); }

private:
  // All pairs of segments that share a border, the lower one first.
  std::set<std::pair<Index, Index>> neighbors() const
  {
    std::set<std::pair<Index, Index>> result;
    const Weighted_dual_graph& graph = m_partition.graph();
    for (Index f = 0; f < graph.number_of_nodes(); ++f)
      for (Index arc : graph.arcs(f))
        if (m_partition.segment(f) < m_partition.segment(graph.target[arc]))
          result.emplace(m_partition.segment(f), m_partition.segment(graph.target[arc]));
    return result;
  }

  // While a border moves, both segments are one, with two sides: the smaller one is the inner.
  void refine(Index s, Index t)
  {
    constexpr Band band = {0.05, 1.4, 0.7};
    if (m_partition.area(m_faces[s]) > m_partition.area(m_faces[t]))
      std::swap(s, t);
    Nodes both;
    std::merge(m_faces[s].begin(), m_faces[s].end(), m_faces[t].begin(), m_faces[t].end(), std::back_inserter(both));
    for (Index f : m_faces[s])
      m_partition.set_segment(f, t);
    m_partition.mark(both, m_faces[s]);
    Nodes inner = refine_cut(m_partition, t, both, m_faces[s], band, m_number);
    inner = m_partition.connect_sides(both, t, inner);
    if (is_large_enough(m_partition.area(inner), m_partition.area(both))) // or else the border stays where it is
    {
      m_faces[s] = std::move(inner);
      m_faces[t].clear();
      std::set_difference(both.begin(), both.end(), m_faces[s].begin(), m_faces[s].end(),
                          std::back_inserter(m_faces[t]));
    }
    for (Index f : m_faces[s])
      m_partition.set_segment(f, s);
  }

  Graph_partition m_partition;
  std::vector<Nodes> m_faces; // of every segment, ascending
  std::vector<Index> m_number;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_FACE_BORDERS_H
