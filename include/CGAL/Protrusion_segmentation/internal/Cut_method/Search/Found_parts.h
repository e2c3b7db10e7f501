// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_FOUND_PARTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_FOUND_PARTS_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Cut_weights.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_memo.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/like_parts.h>

#include <algorithm>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The parts that were found in any segment so far. A smaller segment may have its tips elsewhere: on the thin ring of a gear, so that
// its last tooth is no candidate any more.
class Found_parts
{
public:
  // The weights must outlive the object.
  explicit Found_parts(const Cut_weights& weights) : m_weights(weights) {}

  void add(const std::vector<Cut>& cuts)
  {
    for (const Cut& cut : cuts)
      if (may_be_part(cut) &&
          std::none_of(m_parts.begin(), m_parts.end(), [&](const Part& part) { return part.nodes == cut.inner; }))
        m_parts.push_back({cut.inner, cut.size});
  }

  // Those in a segment that are like one that `set` cuts off, unless its own cuts have about the same part.
  std::vector<Nodes> like_those_of(const Cut_set& set, const Segment& segment, const std::vector<Cut>& cuts) const
  {
    std::vector<Nodes> result;
    for (const auto& [nodes, size] : m_parts)
    {
      const auto is_like = [&, &size = size](const Size_of_part& other)
      { return m_weights.is_like(squared_difference(size, other)); };
      const auto is_about_the_same = [&, &nodes = nodes](const Cut& cut)
      { return is_like(cut.size) && !are_disjoint(cut.inner, nodes); };
      if (std::any_of(set.cuts.begin(), set.cuts.end(), [&](const Cut_set::Made_cut& made) { return is_like(made.size); }) &&
          std::none_of(cuts.begin(), cuts.end(), is_about_the_same) &&
          std::includes(segment.nodes.begin(), segment.nodes.end(), nodes.begin(), nodes.end()))
        result.push_back(nodes);
    }
    return result;
  }

private:
  struct Part
  {
    Nodes nodes; // ascending
    Size_of_part size;
  };

  const Cut_weights& m_weights;
  std::vector<Part> m_parts; // in the order in which they were found
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_SEARCH_FOUND_PARTS_H
