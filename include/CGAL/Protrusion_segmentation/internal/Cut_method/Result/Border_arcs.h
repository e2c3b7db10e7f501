// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_BORDER_ARCS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_BORDER_ARCS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Segment_tree.h>

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The arcs of the dual graph between faces of different segments.
class Border_arcs
{
public:
  using Index = Dual_graph::Index;

  struct Arc
  {
    Index source, target; // faces
    float length;         // of the edge
  };

  // `labels`: the segment of every face; to outlive the object
  Border_arcs(const Dual_graph& graph, const std::vector<Index>& labels, bool is_parallel)
    : m_labels(labels)
  {
    std::vector<std::vector<Arc>> blocks(number_of_blocks(labels.size()));
    for_each_block(labels.size(), is_parallel,
                   [&](std::size_t begin, std::size_t end, std::size_t block)
                   {
                     for (Index f = static_cast<Index>(begin); f < end; ++f)
                       for (Index arc : graph.arcs(f))
                         if (labels[f] != labels[graph.target[arc]])
                           blocks[block].push_back({f, graph.target[arc], graph.border_length[arc]});
                   });
    for (const std::vector<Arc>& arcs : blocks)
      m_arcs.insert(m_arcs.end(), arcs.begin(), arcs.end());
  }

  // ascending
  const std::vector<Arc>& arcs() const { return m_arcs; }

  // of every two neighbouring segments, the lower one first
  Segment_tree::Lengths lengths() const
  {
    Segment_tree::Lengths result;
    for (const Arc& arc : m_arcs)
      if (m_labels[arc.source] < m_labels[arc.target])
        result[{m_labels[arc.source], m_labels[arc.target]}] += arc.length;
    return result;
  }

private:
  const std::vector<Index>& m_labels;
  std::vector<Arc> m_arcs;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_BORDER_ARCS_H
