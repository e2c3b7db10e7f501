// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_SEGMENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_SEGMENTS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Protrusion.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Component_cuts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_set.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Face_borders.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Borders_of_cuts.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Segment_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The segments of a connected surface that a set of cuts makes: the faces of each, how they hang together, and what is
// to be told of them. The body is segment 0; the others are in the order in which their borders were chosen.
class Component_segments
{
public:
  using Index = Indexed_surface::Index;
  using Nodes = Graph_partition::Nodes;

  Component_segments(const Component_cuts& cuts, const Cut_set& set, const Cut_policy& policy, Execution& execution)
    : m_cuts(cuts), m_set(set), m_surface(cuts.surface()), m_is_parallel(execution.is_parallel()),
      m_labels(cuts.graphs().coarse.node)
  {
    number_leaves();
    for (Index& label : m_labels) // still the node
      label = m_leaf_of_node[label];
    if (policy.moves_borders_on_faces() && set.segments.size() > 1)
      move_borders(execution);
    find_border_arcs();
    arrange();
  }

  std::size_t number_of_segments() const { return m_set.segments.size(); }
  // the segment of every face
  const std::vector<Index>& labels() const { return m_labels; }
  // the segment that each sticks out of; the body is its own
  const std::vector<Index>& parents() const { return m_parents; }

  // All but the body; `tip` is a face of the component.
  std::vector<Protrusion<Index>> protrusions() const
  {
    std::vector<Protrusion<Index>> result(number_of_segments() - 1);
    const std::vector<Nodes> along_borders = faces_along_borders();
    Graph_partition partition(m_cuts.graphs().fine, m_labels);
    for_each_index(
      result.size(), m_is_parallel, partition,
      [&](Graph_partition& own, std::size_t i)
      {
        const Index s = static_cast<Index>(i + 1);
        result[i] = describe(s, along_borders[s], own);
      },
      [](const Graph_partition&) {});
    return result;
  }

private:
  // Between faces of different segments.
  struct Border_arc
  {
    Index source, target;
    float length; // of the edge
  };

  // The segments that are left are the leaves of the tree of cuts.
  void number_leaves()
  {
    m_leaf_of_node.resize(m_cuts.graphs().coarse.graph.number_of_nodes());
    const std::vector<Index> segments = m_set.in_order_of_cuts();
    for (Index leaf = 0; leaf < segments.size(); ++leaf)
    {
      for (Index i : m_cuts.pool()[segments[leaf]].nodes)
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

  // Of a large surface on groups of faces first: on the faces, borders have a short way then.
  void move_borders(Execution& execution)
  {
    const Cut_graphs& graphs = m_cuts.graphs();
    if (graphs.groups)
    {
      const std::vector<Index>& group = graphs.groups->node;
      std::vector<Index> labels(graphs.groups->graph.number_of_nodes());
      for (Index f = 0; f < m_labels.size(); ++f)
        labels[group[f]] = m_labels[f];
      Face_borders borders(graphs.groups->graph, std::move(labels), number_of_segments());
      borders.refine(execution);
      labels = borders.labels();
      for (Index f = 0; f < m_labels.size(); ++f)
        m_labels[f] = labels[group[f]];
    }
    Face_borders borders(graphs.fine, std::move(m_labels), number_of_segments());
    borders.refine(execution, graphs.groups ? band_of_groups : band_of_clusters);
    m_labels = borders.labels();
  }

  // Gives the leaves their final numbers.
  void arrange()
  {
    std::vector<double> areas(number_of_segments(), 0);
    for (Index f = 0; f < m_labels.size(); ++f)
      areas[m_labels[f]] += m_surface.area(f);
    const Borders_of_cuts::Lengths lengths = border_lengths();
    const Segment_tree tree(areas, Borders_of_cuts(lengths, sides_of_cuts())());
    std::vector<std::pair<std::size_t, Index>> order; // by the border to the parent, the body first
    for (Index leaf = 0; leaf < areas.size(); ++leaf)
      order.emplace_back(leaf == tree.body() ? 0 : tree.border_to_parent(leaf) + 1, leaf);
    std::sort(order.begin(), order.end());
    std::vector<Index> number(areas.size());
    for (Index s = 0; s < order.size(); ++s)
      number[order[s].second] = s;
    for (const auto& [border, leaf] : order)
    {
      m_parents.push_back(number[tree.parent(leaf)]);
      m_areas_beyond.push_back(tree.area_beyond(leaf));
      m_values.push_back(border == 0 ? 0 : m_set.cuts[border - 1].value);
      m_probabilities.push_back(border == 0 ? 1 : m_set.cuts[border - 1].probability);
    }
    for (Index& label : m_labels)
      label = number[label];
  }

  std::vector<Sides_of_cut> sides_of_cuts() const
  {
    std::vector<Sides_of_cut> result;
    for (const Cut_set::Made_cut& cut : m_set.cuts)
      result.push_back({m_leaves.at(cut.inner), m_leaves.at(cut.outer)});
    return result;
  }

  void find_border_arcs()
  {
    const Weighted_dual_graph& graph = m_cuts.graphs().fine;
    std::vector<std::vector<Border_arc>> blocks(number_of_blocks(m_labels.size()));
    for_each_block(m_labels.size(), m_is_parallel,
                   [&](std::size_t begin, std::size_t end, std::size_t block)
                   {
                     for (std::size_t f = begin; f < end; ++f)
                       for (Index arc : graph.arcs(static_cast<Index>(f)))
                         if (m_labels[f] != m_labels[graph.target[arc]])
                           blocks[block].push_back({static_cast<Index>(f), graph.target[arc], graph.border_length[arc]});
                   });
    for (const std::vector<Border_arc>& arcs : blocks)
      m_border_arcs.insert(m_border_arcs.end(), arcs.begin(), arcs.end());
  }

  // of every two neighbouring segments, the lower one first
  Borders_of_cuts::Lengths border_lengths() const
  {
    Borders_of_cuts::Lengths result;
    for (const Border_arc& arc : m_border_arcs)
      if (m_labels[arc.source] < m_labels[arc.target])
        result[{m_labels[arc.source], m_labels[arc.target]}] += arc.length;
    return result;
  }

  bool sticks_out_of(Index segment, Index other) const
  {
    while (segment != other && m_parents[segment] != segment)
      segment = m_parents[segment];
    return segment == other;
  }

  // Of every segment the faces at the border to its parent; its first face if it touches that no more, since other borders
  // moved in between.
  std::vector<Nodes> faces_along_borders() const
  {
    std::vector<Nodes> result(number_of_segments());
    for (const Border_arc& arc : m_border_arcs)
    {
      Nodes& faces = result[m_labels[arc.source]];
      if (m_labels[arc.target] == m_parents[m_labels[arc.source]] && (faces.empty() || faces.back() != arc.source))
        faces.push_back(arc.source);
    }
    for (Index s = 1; s < number_of_segments(); ++s)
      if (result[s].empty())
        result[s].push_back(static_cast<Index>(std::find(m_labels.begin(), m_labels.end(), s) - m_labels.begin()));
    return result;
  }

  // The tip is the face of the segment that is farthest from the border to the parent.
  Protrusion<Index> describe(Index s, const Nodes& along_border, Graph_partition& partition) const
  {
    const double unit = std::sqrt(m_surface.area()); // there is no border without area
    const auto [tip, distance] = partition.farthest_node(
      along_border, [&](Index f) { return m_labels[f] == s; }, m_cuts.graphs().fine.lengths());
    Protrusion<Index> result;
    result.segment = s;
    result.parent = m_parents[s];
    result.tip = tip;
    result.border_distance = distance * unit;
    result.value = m_values[s];
    result.probability = m_probabilities[s];
    result.area = m_areas_beyond[s];
    result.border_length = border_length(s) * unit;
    return result;
  }

  // between what lies beyond a border and the rest
  double border_length(Index s) const
  {
    std::vector<bool> is_beyond;
    for (Index t = 0; t < number_of_segments(); ++t)
      is_beyond.push_back(sticks_out_of(t, s));
    double length = 0;
    for (const Border_arc& arc : m_border_arcs)
      if (is_beyond[m_labels[arc.source]] && !is_beyond[m_labels[arc.target]])
        length += arc.length;
    return length;
  }

  const Component_cuts& m_cuts;
  const Cut_set& m_set;
  const Indexed_surface& m_surface;
  bool m_is_parallel;
  std::vector<Index> m_labels;
  std::vector<Border_arc> m_border_arcs; // ascending
  std::vector<Index> m_leaf_of_node;
  std::map<Index, std::vector<Index>> m_leaves; // in every segment of the pool that was one
  std::vector<Index> m_parents; // of every segment
  std::vector<double> m_areas_beyond, m_values, m_probabilities;
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COMPONENT_SEGMENTS_H
