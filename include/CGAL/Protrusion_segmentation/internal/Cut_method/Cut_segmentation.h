// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_policy.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Face_borders.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Tip_orders.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/coarsen_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/distance_orders.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/make_weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/measure_volumes.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Any_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Next_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/distinct_tips.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The surface as the cut method sees it: the faces, and a coarse graph that cuts are searched on.
struct Cut_graphs
{
  Weighted_dual_graph fine;
  Coarse_graph coarse;

  Cut_graphs(const Indexed_surface& surface, const Cut_policy& policy, Execution& execution)
  {
    const Stage_scope stage(execution.observer(), Stage::PREPARATION);
    fine = make_weighted_dual_graph(surface, policy, execution);
    coarse = coarsen(fine, number_of_nodes, execution);
    measure_volumes(surface, coarse.node, coarse.graph);
    // only the coarse graph is made of these: a third of the memory of the surface
    decltype(fine.centre)().swap(fine.centre);
    decltype(fine.concave_border_length)().swap(fine.concave_border_length);
  }

private:
  // The structure of a shape of up to some dozen parts shows in that many nodes; cuts get worse with more,
  // since details come to the fore.
  static constexpr Indexed_surface::Index number_of_nodes = 2000;
};

// Splits the segment with the best cut of all, again and again. Cuts are searched on a coarse graph; the one
// that is chosen is brought to the faces, where a minimum cut in a narrow band makes its border.
class Cut_segmentation
{
public:
  using Index = Indexed_surface::Index;
  using Nodes = Graph_partition::Nodes;

  // Without a distance, tips and level sets are those of the coarse graph itself. The arguments must outlive the
  // object.
  Cut_segmentation(const Indexed_surface& surface,
                   const std::optional<Any_distance>& distance,
                   Execution& execution,
                   const Cut_policy& policy = default_cut_policy())
    : m_surface(surface),
      m_distance(distance),
      m_execution(execution),
      m_observer(execution.observer()),
      m_segments(surface),
      m_graphs(surface, policy, execution),
      m_fine(m_graphs.fine, m_segments.labels()),
      m_coarse(m_graphs.coarse.graph, coarse_labels()),
      m_search(m_coarse, policy),
      m_tip_orders(m_coarse),
      m_face_borders(m_fine, m_coarse, m_graphs.coarse.node, policy),
      m_extract(surface),
      m_states(m_segments.number_of_segments())
  {
    for (Index i = 0; i < m_graphs.coarse.graph.number_of_nodes(); ++i)
      m_states[m_coarse.segment(i)].nodes.push_back(i);
  }

  Nested_segments with_number_of_segments(std::size_t k)
  {
    return split(k, -(std::numeric_limits<double>::infinity)());
  }
  Nested_segments with_evident_protrusions() { return split(std::nullopt, least_evident_value); }

  // Cuts off, for one tip after the other, the protrusion with the most probable border that has the tip but none
  // of the other tips. Not the one of most value: that is the larger, the larger the protrusion is, and a foot
  // would take half of the body with it.
  Nested_segments from_tips(const std::vector<Index>& given_tips)
  {
    const std::vector<Index> tips = distinct_tips(m_surface, given_tips);
    for (std::size_t t = 0; t < tips.size(); ++t)
    {
      const Next_segment progress(m_execution, t, tips.size());
      const Index s = m_fine.segment(tips[t]);
      const Index tip = m_graphs.coarse.node[tips[t]];
      if (m_coarse.segment(tip) != s) // in the band of a border made before
        continue;
      const std::vector<bool> is_other_tip = nodes_of_other_tips(tip, tips);
      const auto has_this_tip_only = [&](const Nodes& nodes)
      {
        return std::find(nodes.begin(), nodes.end(), tip) != nodes.end() &&
               std::none_of(nodes.begin(), nodes.end(), [&](Index i) { return is_other_tip[i]; });
      };
      std::vector<Cut> cuts = m_search.cuts(s, m_states[s].nodes, orders_with_tip(s, tip), has_this_tip_only);
      cuts.erase(std::remove_if(cuts.begin(), cuts.end(), [&](const Cut& cut) { return !has_this_tip_only(cut.inner); }),
                 cuts.end());
      const auto best = std::max_element(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b)
                                         { return a.probability < b.probability; });
      if (best != cuts.end())
        cut_off(s, *best);
    }
    return finish();
  }

private:
  // Cuts of less value are not evident. Above 0 people would rather cut than not; between .02 and .04 the Rand
  // index error hardly changes (.112 to .114 on half of the development models of the Princeton benchmark), while
  // the mean number of segments falls from 6.7 to 5.8, people having 8. At .03 the body of a star with three arms
  // falls apart.
  static constexpr double least_evident_value = 0.04;

  // of a segment
  struct State
  {
    Nodes nodes;           // of the coarse graph
    std::vector<Cut> cuts; // best first
    bool is_searched = false;
  };

  std::vector<Index> coarse_labels() const
  {
    std::vector<Index> labels(m_graphs.coarse.graph.number_of_nodes());
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      labels[m_graphs.coarse.node[f]] = m_segments.labels()[f];
    return labels;
  }

  // Two tips in one node are one.
  std::vector<bool> nodes_of_other_tips(Index tip, const std::vector<Index>& tips) const
  {
    std::vector<bool> result(m_graphs.coarse.graph.number_of_nodes(), false);
    for (Index other : tips)
      result[m_graphs.coarse.node[other]] = m_graphs.coarse.node[other] != tip;
    return result;
  }

  std::vector<Nodes> orders(Index s)
  {
    const Stage_scope stage(m_observer, Stage::TIPS);
    if (!m_distance)
      return m_tip_orders.from_all_tips(s, m_states[s].nodes);
    return distance_orders(m_coarse, m_states[s].nodes, m_graphs.coarse.node,
                           m_extract(m_segments.faces(s)), *m_distance, m_execution);
  }
  std::vector<Nodes> orders_with_tip(Index s, Index tip)
  {
    std::vector<Nodes> result = orders(s);
    result.push_back(m_tip_orders.from_tip(s, tip).nodes);
    return result;
  }

  Nested_segments split(std::optional<std::size_t> k, double least_value)
  {
    while (!k || m_segments.number_of_segments() < *k)
    {
      const Next_segment progress(m_execution, m_segments.number_of_segments(), k);
      search_new_segments();
      const std::optional<Index> best = segment_with_best_cut(least_value);
      if (!best)
        break;
      const Cut cut = std::move(m_states[*best].cuts.front());
      m_states[*best].cuts.erase(m_states[*best].cuts.begin());
      cut_off(*best, cut);
    }
    return finish();
  }

  Nested_segments finish()
  {
    m_observer.distances_computed(m_tip_orders.number_of_runs());
    return std::move(m_segments);
  }

  void search_new_segments()
  {
    for (Index s = 0; s < m_states.size(); ++s)
    {
      if (m_states[s].is_searched)
        continue;
      m_execution.check();
      const std::vector<Nodes> of_tips = orders(s);
      const Stage_scope stage(m_observer, Stage::BORDERS);
      m_execution.check();
      m_states[s].cuts = m_search.cuts(s, m_states[s].nodes, of_tips);
      m_states[s].is_searched = true;
    }
  }

  std::optional<Index> segment_with_best_cut(double least_value) const
  {
    std::optional<Index> best;
    for (Index s = 0; s < m_states.size(); ++s)
      if (!m_states[s].cuts.empty() && m_states[s].cuts.front().value > least_value &&
          (!best || m_states[s].cuts.front().value > m_states[*best].cuts.front().value))
        best = s;
    return best;
  }

  // Makes the smaller side of a cut a segment of its own, unless all faces lie on one side. Which one is smaller
  // is decided on the faces: there, the border has moved.
  void cut_off(Index s, const Cut& cut)
  {
    const Stage_scope stage(m_observer, Stage::LABELS);
    Nodes inner = cut.inner;
    Nodes inner_faces = m_face_borders.inner_faces(s, m_segments.faces(s), m_states[s].nodes, inner);
    if (inner_faces.empty() || inner_faces.size() == m_segments.faces(s).size())
      return;
    if (2 * m_fine.area(inner_faces) > m_fine.area(m_segments.faces(s)))
    {
      inner_faces = turn_over(m_fine, m_segments.faces(s));
      inner = turn_over(m_coarse, m_states[s].nodes);
    }
    report(s, cut, inner_faces);
    const Index id = m_segments.cut_off(s, [&](Index f) { return m_fine.is_inner(f); });
    for (Index f : m_segments.faces(id))
      m_fine.set_segment(f, id);
    m_states.emplace_back();
    move_nodes(s, inner, id);
  }

  // Marks the other side of a cut; returns it.
  static Nodes turn_over(Graph_partition& partition, const Nodes& nodes)
  {
    for (Index i : nodes)
      partition.set_inner(i, !partition.is_inner(i));
    return partition.marked(nodes);
  }

  void move_nodes(Index s, const Nodes& inner, Index id)
  {
    m_coarse.mark(m_states[s].nodes, inner);
    Nodes rest;
    for (Index i : m_states[s].nodes)
      (m_coarse.is_inner(i) ? m_states[id].nodes : rest).push_back(i);
    for (Index i : m_states[id].nodes)
      m_coarse.set_segment(i, id);
    m_states[s].nodes = std::move(rest);
    m_states[s].is_searched = false;
  }

  // `inner_faces` are marked and still belong to their parent.
  void report(Index parent, const Cut& cut, const Nodes& inner_faces)
  {
    const double unit = std::sqrt(m_surface.area()); // there is no cut without area
    const auto [along_cut, outside] = m_fine.nodes_along_cut(parent, inner_faces);
    const Nodes_by_distance from_cut =
      m_fine.nodes_by_distance_on_side(along_cut, parent, true, m_graphs.fine.lengths());
    Protrusion<Index> protrusion;
    protrusion.segment = m_segments.number_of_segments();
    protrusion.parent = parent;
    protrusion.value = cut.value;
    protrusion.area = m_fine.area(inner_faces) * unit * unit;
    protrusion.border_length = border_length(inner_faces) * unit;
    protrusion.tip = from_cut.nodes.back();
    protrusion.border_distance = from_cut.distances.back() * unit;
    m_observer.tip_selected(protrusion.tip);
    m_observer.protrusion_found(protrusion);
  }

  // Of the edges between marked faces and all others, in whatever segment they are.
  double border_length(const Nodes& inner_faces) const
  {
    const Index segment = m_fine.segment(inner_faces.front());
    double length = 0;
    for (Index f : inner_faces)
      for (Index arc : m_graphs.fine.arcs(f))
        if (!m_fine.is_inner(m_graphs.fine.target[arc]) || m_fine.segment(m_graphs.fine.target[arc]) != segment)
          length += m_graphs.fine.border_length[arc];
    return length;
  }

  const Indexed_surface& m_surface;
  const std::optional<Any_distance>& m_distance;
  Execution& m_execution;
  Observer& m_observer;
  Nested_segments m_segments;
  Cut_graphs m_graphs;
  Graph_partition m_fine;
  Graph_partition m_coarse;
  Cut_search m_search;
  Tip_orders m_tip_orders;
  Face_borders m_face_borders;
  Segment_extractor m_extract;
  std::vector<State> m_states; // of every segment
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H
