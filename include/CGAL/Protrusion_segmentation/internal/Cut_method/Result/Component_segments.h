// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_COMPONENT_SEGMENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_COMPONENT_SEGMENTS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/divide_long_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Border_arcs.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Face_borders.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/labels_of_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_memo.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Segment_tree.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The faces of a surface as the results see them: of one with long faces, the search knows pieces only.
struct Faces_of_surface
{
  const Seam_graph& graph;
  const Divided_surface* divided; // if there are long faces
};

// The segments of a connected surface that a set of cuts makes: the faces of each and their tree. The body is segment 0, the others
// are in the order of the values of the cuts that separate them from what they stick out of, the most valuable one first.
class Component_segments
{
public:
  using Index = Indexed_surface::Index;

  Component_segments(const Faces_of_surface& faces,
                     const Graphs_of_surface& graphs,
                     const Segment_memo& memo,
                     const Cut_set& set,
                     const Cut_options& options,
                     Execution& execution)
    : m_faces(faces.graph),
      m_graphs(graphs),
      m_memo(memo),
      m_set(set),
      m_is_parallel(execution.is_parallel()),
      m_labels(graphs.node_of_face)
  {
    number_leaves();
    for (Index& label : m_labels) // still the node
      label = m_leaf_of_node[label];
    if (options.moves_borders_on_faces && set.segments.size() > 1)
      m_labels = Face_borders(graphs.fine, std::move(m_labels), number_of_segments())(execution);
    if (faces.divided)
      m_labels = Face_labeler(m_faces, faces.divided->face_of_piece, graphs.fine.area, m_labels)(number_of_segments());
    arrange();
  }

  std::size_t number_of_segments() const { return m_set.segments.size(); }
  // the segment of every face
  const std::vector<Index>& labels() const { return m_labels; }
  // of each, that of the memo
  const std::vector<Index>& segments_of_memo() const { return m_segments_of_memo; }
  // the segment that each sticks out of; the body is its own
  const std::vector<Index>& parents() const { return m_parents; }
  // of each with all that sticks out of it
  const std::vector<double>& areas_beyond() const { return m_areas_beyond; }
  // the cut whose border each has to its parent; none of the body
  const Cut_set::Made_cut* cut(std::size_t segment) const
  {
    return m_cuts[segment] ? &m_set.cuts[*m_cuts[segment]] : nullptr;
  }

private:
  using Cuts = std::vector<std::optional<std::size_t>>; // of every segment, by their numbers in the set; none of the body

  // The segments that are left are the leaves of the tree of cuts.
  void number_leaves()
  {
    m_leaf_of_node.resize(m_graphs.coarse.number_of_nodes());
    const std::vector<Index> segments = m_set.in_order_of_cuts();
    for (Index leaf = 0; leaf < segments.size(); ++leaf)
    {
      for (Index i : m_memo[segments[leaf]].segment.nodes)
        m_leaf_of_node[i] = leaf;
      m_leaves[segments[leaf]] = {leaf};
    }
    for (auto cut = m_set.cuts.rbegin(); cut != m_set.cuts.rend(); ++cut)
    {
      std::vector<Index> both = m_leaves[cut->inner];
      both.insert(both.end(), m_leaves[cut->outer].begin(), m_leaves[cut->outer].end());
      m_leaves[cut->segment] = std::move(both);
    }
  }

  // Gives the leaves their final numbers.
  void arrange()
  {
    std::vector<double> areas(number_of_segments(), 0);
    for (Index f = 0; f < m_labels.size(); ++f)
      areas[m_labels[f]] += m_faces.area[f];
    const Segment_tree::Lengths lengths = Border_arcs(m_faces, m_labels, m_is_parallel).lengths();
    const Segment_tree tree(areas, lengths);
    const Cuts cuts = cuts_of_borders(tree, lengths);
    std::vector<Index> order(areas.size());
    std::iota(order.begin(), order.end(), Index(0));
    const auto rank = [&](Index leaf) // equal ones in the order in which they were made
    {
      const std::optional<std::size_t>& cut = cuts[leaf];
      return std::make_pair(cut ? -m_set.cuts[*cut].value : -std::numeric_limits<double>::infinity(), cut);
    };
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return rank(a) < rank(b); });
    std::vector<Index> number(areas.size());
    for (Index s = 0; s < order.size(); ++s)
      number[order[s]] = s;
    const std::vector<Index> segments_of_leaves = m_set.in_order_of_cuts();
    for (Index leaf : order)
    {
      m_segments_of_memo.push_back(segments_of_leaves[leaf]);
      m_parents.push_back(number[tree.parent(leaf)]);
      m_areas_beyond.push_back(tree.area_beyond(leaf));
      m_cuts.push_back(cuts[leaf]);
    }
    for (Index& label : m_labels)
      label = number[label];
  }

  // Of every leaf the cut of its border to its parent: the one that separated the two. A cut that separated several gets the
  // longest of these borders. The others get the cuts that are left, if possible one within the segment of which they came.
  Cuts cuts_of_borders(const Segment_tree& tree, const Segment_tree::Lengths& lengths) const
  {
    const auto length = [&](Index leaf) { return lengths.at(std::minmax(leaf, tree.parent(leaf))); };
    Cuts result(number_of_segments());
    std::vector<bool> is_left(m_set.cuts.size(), true);
    for (const int nearness : {2, 1, 0})
      for (std::size_t c = m_set.cuts.size(); c-- > 0;)
      {
        if (!is_left[c])
          continue;
        const std::vector<int> side = sides_of(m_set.cuts[c]);
        std::optional<Index> longest;
        for (Index leaf = 0; leaf < result.size(); ++leaf)
          if (leaf != tree.body() && !result[leaf] &&
              nearness_of(side, leaf, tree.parent(leaf)) >= nearness &&
              (!longest || length(leaf) > length(*longest)))
            longest = leaf;
        if (!longest)
          continue;
        result[*longest] = c;
        is_left[c] = false;
      }
    return result;
  }

  // Of every leaf: 1 if it is on the inner side of a cut, -1 on the outer, 0 on none.
  std::vector<int> sides_of(const Cut_set::Made_cut& cut) const
  {
    std::vector<int> result(number_of_segments(), 0);
    for (Index leaf : m_leaves.at(cut.inner))
      result[leaf] = 1;
    for (Index leaf : m_leaves.at(cut.outer))
      result[leaf] = -1;
    return result;
  }

  static int nearness_of(const std::vector<int>& side, Index leaf, Index parent)
  {
    return side[leaf] * side[parent] < 0 ? 2 : side[leaf] != 0 ? 1 : 0;
  }

  const Seam_graph& m_faces;
  const Graphs_of_surface& m_graphs;
  const Segment_memo& m_memo;
  const Cut_set& m_set;
  bool m_is_parallel;
  std::vector<Index> m_labels;
  std::vector<Index> m_leaf_of_node;
  std::map<Index, std::vector<Index>> m_leaves; // in every segment of the memo that was one
  std::vector<Index> m_segments_of_memo;        // of every segment
  std::vector<Index> m_parents;                 // of every segment
  std::vector<double> m_areas_beyond;           // of every segment
  Cuts m_cuts;                                  // of every segment
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_COMPONENT_SEGMENTS_H
