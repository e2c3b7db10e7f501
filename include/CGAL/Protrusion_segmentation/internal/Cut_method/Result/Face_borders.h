// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_FACE_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_FACE_BORDERS_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Local_connectivity.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/minimum_cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Border_arcs.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Moves the borders of a segmentation of the faces: between any two neighbouring segments the border becomes the minimum cut in a
// narrow band around it.
class Face_borders
{
public:
  using Index = Dual_graph::Index;

  // `labels`: the segment of every face, each of them connected
  Face_borders(const Seam_graph& graph, std::vector<Index> labels, std::size_t number_of_segments)
    : m_partition(graph, std::move(labels)),
      m_distances(graph),
      m_minimum_cut(m_partition, m_distances),
      m_connectivity(m_partition),
      m_faces(number_of_segments)
  {
    for (Index f = 0; f < graph.number_of_nodes(); ++f)
      m_faces[m_partition.label(f)].push_back(f);
    for (const Nodes& faces : m_faces)
      m_area.push_back(graph.area_of(faces));
  }
  Face_borders(const Face_borders&) = delete;
  Face_borders& operator=(const Face_borders&) = delete;

  // Returns the segment of every face.
  std::vector<Index> operator()(Execution& execution)
  {
    constexpr int number_of_rounds = 2; // a border may change where another one meets it
    for (int round = 0; round < number_of_rounds; ++round)
      for (const auto& border : Border_arcs(m_partition.graph(), labels(), execution.is_parallel()).lengths())
      {
        execution.check();
        refine(border.first.first, border.first.second);
      }
    return labels();
  }

private:
  // the segment of every face
  std::vector<Index> labels() const
  {
    std::vector<Index> labels(m_partition.graph().number_of_nodes());
    for (Index f = 0; f < labels.size(); ++f)
      labels[f] = m_partition.label(f);
    return labels;
  }

  // While a border moves, both segments are one, with two sides: the smaller one is the inner. No node is marked before
  // or after.
  void refine(Index s, Index t)
  {
    constexpr Band band = {0.05, 1.4, 0.7, 0.015}; // from .01 to .02 for the widest there is no difference
    if (m_area[s] > m_area[t])
      std::swap(s, t);
    m_partition.select(t);
    for (Index f : m_faces[s])
      m_partition.set_inner(f, true);
    const Nodes changed = m_minimum_cut.nodes_to_move(m_faces[s], band);
    for (Index f : changed)
      m_partition.set_inner(f, !m_partition.is_inner(f));
    Nodes inner, outer;
    if (m_connectivity.is_connected(true, changed) && m_connectivity.is_connected(false, changed))
    {
      inner = with_changes(m_faces[s], changed, true);
      outer = with_changes(m_faces[t], changed, false);
    }
    else if (!changed.empty())
      connect_sides(s, t, inner, outer);
    for (const Nodes* nodes : {&changed, &static_cast<const Nodes&>(m_faces[s]), &static_cast<const Nodes&>(inner)})
      for (Index f : *nodes)
        m_partition.set_inner(f, false);
    const double area = m_partition.graph().area_of(inner);
    if (are_kept(area, s, t)) // or else the border stays where it is
    {
      m_faces[s] = std::move(inner);
      m_faces[t] = std::move(outer);
      m_area[s] = area;
      m_area[t] = m_partition.graph().area_of(m_faces[t]);
    }
    for (Index f : m_faces[s])
      m_partition.set_label(f, s);
  }

  // Whether both segments keep most of their area, the first one `area`. Else a side fell apart, and the other one would get
  // what is no part of it, as an arm the underside of the body between all arms.
  bool are_kept(double area, Index s, Index t) const
  {
    constexpr double least_share = 0.75; // an octopus's body kept .64 of its area, decisions.md
    const double both = m_area[s] + m_area[t];
    return is_large_enough(area, both) && area >= least_share * m_area[s] && both - area >= least_share * m_area[t];
  }

  // The nodes of a side after some have changed: without those that left, and with those that came.
  Nodes with_changes(const Nodes& nodes, const Nodes& changed, bool inner) const
  {
    Nodes stayed, came, result;
    stayed.reserve(nodes.size());
    std::set_difference(nodes.begin(), nodes.end(), changed.begin(), changed.end(), std::back_inserter(stayed));
    std::copy_if(changed.begin(), changed.end(), std::back_inserter(came),
                 [&](Index f) { return m_partition.is_inner(f) == inner; });
    result.reserve(stayed.size() + came.size());
    std::merge(stayed.begin(), stayed.end(), came.begin(), came.end(), std::back_inserter(result));
    return result;
  }

  // The nodes of both sides, made connected.
  void connect_sides(Index s, Index t, Nodes& inner, Nodes& outer)
  {
    Nodes both;
    std::merge(m_faces[s].begin(), m_faces[s].end(), m_faces[t].begin(), m_faces[t].end(), std::back_inserter(both));
    inner = m_partition.connect_sides(both, m_partition.marked(both));
    std::set_difference(both.begin(), both.end(), inner.begin(), inner.end(), std::back_inserter(outer));
  }

  Graph_partition m_partition;
  Graph_distances m_distances;
  Minimum_cut m_minimum_cut;
  Local_connectivity m_connectivity;
  std::vector<Nodes> m_faces; // of every segment, ascending
  std::vector<double> m_area; // of every segment
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_RESULT_FACE_BORDERS_H
