// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CUT_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CUT_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Bisection.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Clues_of_cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Local_connectivity.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/minimum_cut.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graph_partition.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// How large a part is that a cut separates, as logarithms.
struct Size_of_part
{
  double area = 0, length = 0, thickness = 0; // length: that of the cut
  bool is_repeated = false;                   // whether an earlier cut, or a surer one, separates nearly the same part
};

inline double squared_difference(const Size_of_part& a, const Size_of_part& b)
{
  const double area = a.area - b.area, length = a.length - b.length, thickness = a.thickness - b.thickness;
  return area * area + length * length + thickness * thickness;
}

// A cut of a segment in two connected sides.
struct Cut
{
  Nodes inner;              // of smaller area, or with the tip that was given
  double root_of_areas = 0; // of the product of the areas of both sides
  Cut_clues clues = {};
  Size_of_part size = {};   // see `Sizes_of_parts`
  double log_odds = 0;      // of the sides belonging apart, by the clues alone
  double like_part = 0;     // what a part like this one, elsewhere in the segment, adds to these
  double value = 0;         // higher is better, below 0 it separates what belongs together
};

// The value of a cut: the probability that the sides belong apart, less the one that they belong together, times the root of the
// product of their areas. The product itself, the number of pairs of points on different sides, would have the largest segments cut
// for their size alone.
inline double value_of_cut(double log_odds, double root_of_areas)
{
  return (2 * logistic(log_odds) - 1) * root_of_areas;
}

// Values a cut by its clues.
inline void value_by_clues(const Cut_weights& weights, Cut& cut)
{
  cut.log_odds = weights(cut.clues);
  cut.value = value_of_cut(cut.log_odds, cut.root_of_areas);
}

// Equal ones stay in their order.
inline void sort_best_first(std::vector<Cut>& cuts)
{
  std::stable_sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.value > b.value; });
}

// Adds a cut, if there is one. Minimum cuts near different candidates may be the same.
inline void add_different(std::vector<Cut>& cuts, std::optional<Cut> cut)
{
  if (cut && std::none_of(cuts.begin(), cuts.end(), [&](const Cut& other) { return other.inner == cut->inner; }))
    cuts.push_back(std::move(*cut));
}

// Makes cuts on a coarse graph. Work arrays are kept.
class Cutter
{
public:
  using Index = Dual_graph::Index;

  // The arguments must outlive the object.
  Cutter(const Volume_graph& graph, const Cut_options& options, Graph_partition& partition, Graph_distances& distances)
    : m_graph(graph),
      m_options(options),
      m_partition(partition),
      m_strips(graph, distances),
      m_minimum_cut(partition, distances),
      m_connectivity(partition)
  {}

  // The cut around connected nodes of a segment, the other side made connected as well. The minimum cut near it takes its place if that is
  // cheaper for the areas of its sides. There is none if a side is too small or too narrow to be a segment.
  std::optional<Cut> cut_around(const Segment& segment, const Nodes& nodes)
  {
    Bisection bisection(m_partition, segment);
    change_sides(nodes);
    take_marked(bisection, m_connectivity.is_connected(false, nodes));
    move_to_minimum_cut(bisection);
    if (!bisection.has_large_sides())
      return std::nullopt;
    Clues_of_cut clues(m_graph, bisection);
    if (clues.is_band_in_seam())
      return std::nullopt;
    Cut cut;
    cut.inner = bisection.inner();
    cut.root_of_areas = std::sqrt(bisection.inner_area() * (segment.area - bisection.inner_area()));
    cut.clues = clues(m_strips);
    value_by_clues(m_options.weights, cut);
    return cut;
  }

  const Minimum_cut& minimum_cut() const { return m_minimum_cut; }

private:
  void move_to_minimum_cut(Bisection& bisection)
  {
    constexpr Band band = {0.35, 1.4, 0.7};
    const Nodes moved = m_minimum_cut.nodes_to_move(bisection.inner(), band);
    if (moved.empty())
      return;
    const Nodes old_side = bisection.inner();
    const double old_cost = bisection.relative_cost();
    change_sides(moved);
    take_marked(bisection, m_connectivity.is_connected(true, moved) && m_connectivity.is_connected(false, moved));
    if (!(bisection.relative_cost() < old_cost))
      bisection.set_connected_side(old_side);
  }

  void change_sides(const Nodes& nodes)
  {
    for (Index i : nodes)
      m_partition.set_inner(i, !m_partition.is_inner(i));
  }

  // Makes the marked nodes the inner side. `are_connected`: whether both sides are seen to be connected
  void take_marked(Bisection& bisection, bool are_connected)
  {
    Nodes side = m_partition.marked(bisection.segment().nodes);
    if (are_connected)
      bisection.set_connected_side(std::move(side));
    else
      bisection.set_side(side);
  }

  const Volume_graph& m_graph;
  const Cut_options& m_options;
  Graph_partition& m_partition;
  Strip_measurer m_strips;
  Minimum_cut m_minimum_cut;
  Local_connectivity m_connectivity;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_CUT_H
