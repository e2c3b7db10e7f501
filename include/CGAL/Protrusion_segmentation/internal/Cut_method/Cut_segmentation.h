// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_search.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph_partition.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/Monitor.h>
#include <CGAL/Protrusion_segmentation/internal/Segments/Nested_segments.h>
#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/coarsen_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/make_weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/minimum_cut.h>
#include <CGAL/Protrusion_segmentation/internal/Tips/select_protrusion_tips.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// Splits the part with the best cut of all, again and again. Cuts are searched on a coarse graph; the one
// that is taken is transferred to the faces, where a minimum cut in a narrow band makes its border.
template <typename Distance, typename Visitor>
class Cut_segmentation
{
public:
  using Index = Indexed_surface::Index;
  using Nodes = Graph_partition::Nodes;

  Cut_segmentation(const Indexed_surface& surface,
                   const Distance& distance,
                   Monitor<Visitor>& monitor,
                   const Cut_ingredients& ingredients = {})
    : m_surface(surface),
      m_distance(distance),
      m_monitor(monitor),
      m_ingredients(ingredients),
      m_forest(surface),
      m_fine_graph(make_weighted_dual_graph(surface, ingredients)),
      m_coarse(make_coarse_graph(m_fine_graph)),
      m_fine(m_fine_graph, m_forest.labels),
      m_coarse_partition(m_coarse.graph, coarse_labels()),
      m_search(m_coarse_partition, ingredients),
      m_extract(surface),
      m_number(surface.number_of_faces(), Indexed_surface::no_face()),
      m_parts(m_forest.number_of_segments())
  {
    for (Index i = 0; i < m_coarse.graph.number_of_nodes(); ++i)
      m_parts[m_coarse_partition.label(i)].nodes.push_back(i);
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      m_parts[m_forest.labels[f]].faces.push_back(f);
  }

  Nested_segments with_number_of_segments(std::size_t k) { return split(k, -(std::numeric_limits<double>::infinity)()); }
  Nested_segments with_evident_protrusions()
  {
    return split(Monitor<Visitor>::unlimited(), least_evident_value);
  }

  // Cuts off, for one tip after the other, the protrusion with the best border that has the tip but none of
  // the other tips.
  Nested_segments from_tips(const std::vector<Index>& tips)
  {
    for (Index tip : tips)
    {
      m_monitor.check();
      const Index p = m_fine.label(tip);
      if (m_coarse_partition.label(m_coarse.node[tip]) != p) // in the band of a border made before
        continue;
      const auto has_this_tip_only = [&](const Nodes& nodes) { return is_only_tip(tip, tips, nodes); };
      const std::vector<Cut> cuts =
        m_search.cuts(p, m_parts[p].nodes, fields_of_tips(p, tips), has_this_tip_only);
      const auto best = std::find_if(cuts.begin(), cuts.end(), [&](const Cut& cut)
                                     { return has_this_tip_only(cut.inner); });
      if (best != cuts.end())
        take(p, *best);
    }
    return finish();
  }

private:
  // The structure of a shape of up to some dozen parts shows in that many nodes; cuts get worse with more,
  // since details come to the fore.
  static constexpr Index number_of_nodes = 2000;
  // Cuts of less value are not evident. Above 0 people would rather cut than not; between .02 and .04 the Rand
  // index error hardly changes (.112 to .114 on half of the development models of the Princeton benchmark), while
  // the mean number of segments falls from 6.7 to 5.8, people having 8. At .03 the body of a star with three arms
  // falls apart.
  static constexpr double least_evident_value = 0.04;

  struct Part
  {
    Nodes nodes; // of the coarse graph
    Nodes faces;
    std::vector<Cut> cuts; // best first
    bool is_searched = false;
  };

  // Takes from the fine graph what only the coarse one is made of: a third of the memory of the surface.
  static Coarse_graph make_coarse_graph(Weighted_dual_graph& fine)
  {
    Coarse_graph result = coarsen(fine, number_of_nodes);
    decltype(fine.centre)().swap(fine.centre);
    decltype(fine.concave_border_length)().swap(fine.concave_border_length);
    return result;
  }

  std::vector<Index> coarse_labels() const
  {
    std::vector<Index> labels(m_coarse.graph.number_of_nodes());
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      labels[m_coarse.node[f]] = m_forest.labels[f];
    return labels;
  }

  // The fields of the tips in a part, a search of its own for tips included.
  std::vector<Nodes> fields_of_tips(Index p, const std::vector<Index>& tips)
  {
    std::vector<Nodes> result = fields(p);
    for (Index tip : tips)
      if (m_coarse_partition.label(m_coarse.node[tip]) == p)
        result.push_back(m_search.field_of_tip(p, m_coarse.node[tip]));
    return result;
  }

  bool is_only_tip(Index tip, const std::vector<Index>& tips, const Nodes& nodes) const
  {
    const auto is_inside = [&](Index other)
    { return std::find(nodes.begin(), nodes.end(), m_coarse.node[other]) != nodes.end(); };
    return is_inside(tip) && std::none_of(tips.begin(), tips.end(),
                                          [&](Index other) { return other != tip && is_inside(other); });
  }

  Nested_segments split(std::size_t k, double least_value)
  {
    while (m_forest.number_of_segments() < k)
    {
      m_monitor.progress(m_forest.number_of_segments(), k);
      search_new_parts();
      const std::optional<Index> best = part_with_best_cut(least_value);
      if (!best)
        break;
      const Cut cut = std::move(m_parts[*best].cuts.front());
      m_parts[*best].cuts.erase(m_parts[*best].cuts.begin());
      take(*best, cut);
    }
    return finish();
  }

  Nested_segments finish()
  {
    m_monitor.visitor().distances_computed(m_search.number_of_runs());
    m_forest.labels = m_fine.labels();
    return std::move(m_forest);
  }

  void search_new_parts()
  {
    const Stage_scope<Visitor> stage(m_monitor.visitor(), Stage::TIPS);
    for (Index p = 0; p < m_parts.size(); ++p)
    {
      if (m_parts[p].is_searched)
        continue;
      m_monitor.check();
      m_parts[p].cuts = m_search.cuts(p, m_parts[p].nodes, fields(p));
      m_parts[p].is_searched = true;
    }
  }

  std::optional<Index> part_with_best_cut(double least_value) const
  {
    std::optional<Index> best;
    for (Index p = 0; p < m_parts.size(); ++p)
      if (!m_parts[p].cuts.empty() && m_parts[p].cuts.front().value > least_value &&
          (!best || m_parts[p].cuts.front().value > m_parts[*best].cuts.front().value))
        best = p;
    return best;
  }

  // The geodesic distance is computed on the coarse graph, with arcs lengthened across concave seams; any
  // other distance on the faces of the part, a node being as far as its faces are on average.
  std::vector<Nodes> fields(Index p)
  {
    if constexpr (std::is_same_v<Distance, Geodesic_distance>)
      return m_search.tip_fields(p, m_parts[p].nodes);
    else
      return fields_of_distance(p);
  }

  std::vector<Nodes> fields_of_distance(Index p)
  {
    constexpr std::size_t number_of_tips = 6; // every one costs a distance computation on all faces
    const Extracted_segment extracted = m_extract(m_parts[p].faces);
    auto distances = m_distance.on(extracted.part, m_monitor.random_seed());
    std::vector<Nodes> fields;
    select_protrusion_tips(
      extracted.part, distances, number_of_tips, [](Index) { return true; },
      [&](Index, const std::vector<double>& from_tip)
      {
        std::vector<double> mean(m_coarse.graph.number_of_nodes(), 0);
        std::vector<Index> count(m_coarse.graph.number_of_nodes(), 0);
        for (Index f = 0; f < from_tip.size(); ++f)
        {
          const Index node = m_coarse.node[extracted.faces[f]];
          mean[node] += (from_tip[f] - mean[node]) / ++count[node];
        }
        Nodes order = m_parts[p].nodes;
        std::stable_sort(order.begin(), order.end(),
                         [&](Index a, Index b) { return mean[a] < mean[b]; });
        fields.push_back(std::move(order));
      });
    m_monitor.visitor().distances_computed(distances.number_of_runs());
    return fields;
  }

  // Makes the two sides of a cut parts of their own, unless all faces lie on one side.
  void take(Index p, const Cut& cut)
  {
    const Stage_scope<Visitor> stage(m_monitor.visitor(), Stage::BORDERS);
    const Nodes inner_faces = transfer(p, cut.inner);
    if (inner_faces.empty() || inner_faces.size() == m_parts[p].faces.size())
      return;
    const Index id = m_forest.add_segment(p);
    m_parts.emplace_back();
    move_nodes(m_coarse_partition, m_parts[p].nodes, m_parts[id].nodes, cut.inner, id);
    report(p, id, cut, inner_faces);
    move_nodes(m_fine, m_parts[p].faces, m_parts[id].faces, inner_faces, id);
    m_parts[p].is_searched = false;
  }

  // Gives the nodes of `inner` to part `id`.
  static void move_nodes(
    Graph_partition& partition, Nodes& from, Nodes& to, const Nodes& inner, Index id)
  {
    partition.mark(from, inner);
    Nodes rest;
    for (Index i : from)
      (partition.is_inner(i) ? to : rest).push_back(i);
    for (Index i : to)
      partition.set_label(i, id);
    from = std::move(rest);
  }

  // The faces on the inner side of a coarse cut, with the minimum cut near it as border. Borders made before
  // follow the faces, not the nodes: faces of this part whose node belongs to another part go with their
  // neighbours.
  Nodes transfer(Index p, const Nodes& inner_nodes)
  {
    constexpr Band band = {0.05, 2, 0.7};
    const Nodes& faces = m_parts[p].faces;
    m_coarse_partition.mark(m_parts[p].nodes, inner_nodes);
    Nodes known, inner;
    std::vector<bool> is_known(faces.size(), false);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const Index node = m_coarse.node[faces[i]];
      m_number[faces[i]] = static_cast<Index>(i);
      is_known[i] = m_coarse_partition.label(node) == p;
      m_fine.set_inner(faces[i], is_known[i] && m_coarse_partition.is_inner(node));
      if (is_known[i])
        known.push_back(faces[i]);
    }
    for (std::size_t i = 0; i < known.size(); ++i)
      for (Index arc : m_fine_graph.arcs(known[i]))
      {
        const Index g = m_fine_graph.target[arc];
        if (m_fine.label(g) != p || is_known[m_number[g]])
          continue;
        is_known[m_number[g]] = true;
        m_fine.set_inner(g, m_fine.is_inner(known[i]));
        known.push_back(g);
      }
    for (Index f : faces)
      m_number[f] = Indexed_surface::no_face();
    inner = m_fine.inner_nodes(faces);
    if (inner.empty() || inner.size() == faces.size())
      return inner;
    inner = m_fine.connect_sides(faces, p, inner);
    if (!m_ingredients.minimum_cut_on_faces)
      return inner;
    inner = refine_cut(m_fine, p, faces, inner, band, m_number);
    return m_fine.connect_sides(faces, p, inner);
  }

  // `inner_faces` are marked and still have the label of their parent.
  void report(Index parent, Index id, const Cut& cut, const Nodes& inner_faces)
  {
    const double unit = m_monitor.unit() * std::sqrt(m_surface.area()); // there is no cut without area
    Protrusion protrusion;
    protrusion.segment = id;
    protrusion.parent = parent;
    protrusion.score = cut.value;
    protrusion.area = m_fine.area(inner_faces) * unit * unit;
    double length = 0;
    for (Index f : inner_faces)
      for (Index arc : m_fine_graph.arcs(f))
        if (!m_fine.is_inner(m_fine_graph.target[arc]) || m_fine.label(m_fine_graph.target[arc]) != parent)
          length += m_fine_graph.border_length[arc];
    protrusion.border_length = length * unit;
    const Nodes along_cut = m_fine.nodes_along_cut(parent, inner_faces).first;
    const Nodes order = m_fine.nodes_by_distance(
      along_cut, [&](Index i) { return m_fine.label(i) == parent && m_fine.is_inner(i); },
      m_fine_graph.lengths());
    protrusion.tip = m_monitor.position(order.back());
    protrusion.border_distance = m_fine.distance(order.back()) * unit;
    m_monitor.visitor().tip_found(protrusion.tip);
    m_monitor.visitor().protrusion_found(protrusion);
  }

  const Indexed_surface& m_surface;
  const Distance& m_distance;
  Monitor<Visitor>& m_monitor;
  Cut_ingredients m_ingredients;
  Nested_segments m_forest;
  Weighted_dual_graph m_fine_graph;
  Coarse_graph m_coarse;
  Graph_partition m_fine;
  Graph_partition m_coarse_partition;
  Cut_search m_search;
  Segment_extractor m_extract;
  std::vector<Index> m_number;
  std::vector<Part> m_parts; // by label
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_SEGMENTATION_H
