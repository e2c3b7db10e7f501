// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COARSEN_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COARSEN_GRAPH_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Weighted_dual_graph.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>

#include <CGAL/Protrusion_segmentation/internal/Surface/Float_key.h>

#include <CGAL/number_utils.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// A coarse graph and the node of it that every node of the original graph went into.
struct Coarse_graph
{
  Weighted_dual_graph graph;
  std::vector<Weighted_dual_graph::Index> node;
};

// The nodes by their areas, as far as single precision tells them apart, then by their numbers.
inline std::vector<Float_key> by_area(const Weighted_dual_graph& graph)
{
  std::vector<Float_key> keys;
  keys.reserve(graph.number_of_nodes());
  for (Weighted_dual_graph::Index i = 0; i < graph.number_of_nodes(); ++i)
    keys.push_back(float_key(static_cast<float>(graph.area[i]), i));
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
  return keys;
}

// Pairs every node with the neighbour to which it is tied strongest for its size, small nodes first, as long
// as the pair is no larger than `largest_area`, and no more pairs than `wanted`. Returns for every node the
// number of its pair, and how many there are. `ties`: of every arc.
inline std::pair<std::vector<Weighted_dual_graph::Index>, Weighted_dual_graph::Index> match_neighbors(
  const Weighted_dual_graph& graph,
  const std::vector<float>& ties,
  double largest_area,
  Weighted_dual_graph::Index wanted)
{
  using Index = Weighted_dual_graph::Index;
  const Index n = graph.number_of_nodes();
  const Index unmatched = Indexed_surface::no_face();
  std::vector<Index> partner(n, unmatched);
  Index pairs = 0;
  for (const Float_key key : by_area(graph))
  {
    const Index i = index_of(key);
    if (partner[i] != unmatched || pairs == wanted)
      continue;
    double strongest = -1;
    for (Index arc : graph.arcs(i))
    {
      const Index j = graph.target[arc];
      if (j == i || partner[j] != unmatched || graph.area[i] + graph.area[j] > largest_area)
        continue;
      const double area = graph.area[i] * graph.area[j];
      const double strength =
        area > 0 ? CGAL::square(static_cast<double>(ties[arc])) / area : (std::numeric_limits<double>::max)();
      if (strength > strongest)
      {
        strongest = strength;
        partner[i] = j;
      }
    }
    if (partner[i] != unmatched)
    {
      partner[partner[i]] = i;
      ++pairs;
    }
  }
  std::vector<Index> number(n, unmatched);
  Index count = 0;
  for (Index i = 0; i < n; ++i)
    if (number[i] == unmatched)
    {
      number[i] = count;
      if (partner[i] != unmatched)
        number[partner[i]] = count;
      ++count;
    }
  return {number, count};
}

inline void merge_nodes(const Weighted_dual_graph& graph, const Index_groups& sets, Weighted_dual_graph& result)
{
  using Index = Weighted_dual_graph::Index;
  const Indexed_surface::Point_3 origin(0, 0, 0);
  result.area.assign(sets.number_of_groups(), 0);
  result.centre.reserve(sets.number_of_groups());
  for (Index u = 0; u < sets.number_of_groups(); ++u)
  {
    Indexed_surface::Vector_3 moment(0, 0, 0);
    for (Index i : sets[u])
    {
      result.area[u] += graph.area[i];
      moment += graph.area[i] * (graph.centre_of(i) - origin);
    }
    result.add_centre(result.area[u] > 0 ? origin + moment / result.area[u]
                                         : graph.centre_of(sets[u].front()));
  }
}

inline void merge_arcs(const Weighted_dual_graph& graph,
                       const std::vector<Weighted_dual_graph::Index>& number,
                       const Index_groups& sets,
                       Weighted_dual_graph& result)
{
  using Index = Weighted_dual_graph::Index;
  // more than needed, but memory that is not written to costs nothing, and growing would hold all twice
  result.target.reserve(graph.target.size());
  result.first_arc.reserve(sets.number_of_groups() + 1);
  std::vector<std::vector<float> Weighted_dual_graph::*> sums; // of the weights that the graph has
  for (auto sum : {&Weighted_dual_graph::border_length, &Weighted_dual_graph::concave_border_length,
                   &Weighted_dual_graph::capacity, &Weighted_dual_graph::curvature})
    if (!(graph.*sum).empty())
    {
      sums.push_back(sum);
      (result.*sum).reserve((graph.*sum).size());
    }
  std::vector<Index> arc_to(sets.number_of_groups(), Indexed_surface::no_face()); // if it leaves this node
  for (Index u = 0; u < sets.number_of_groups(); ++u)
  {
    const Index begin = result.first_arc.back();
    for (Index i : sets[u])
      for (Index old : graph.arcs(i))
      {
        const Index v = number[graph.target[old]];
        if (v == u)
          continue;
        Index& arc = arc_to[v];
        if (arc == Indexed_surface::no_face() || arc < begin)
        {
          arc = static_cast<Index>(result.target.size());
          result.target.push_back(v);
          for (auto sum : sums)
            (result.*sum).push_back(0);
        }
        for (auto sum : sums)
          (result.*sum)[arc] += (graph.*sum)[old] * (sum == &Weighted_dual_graph::curvature ? graph.border_length[old] : 1);
      }
    result.first_arc.push_back(static_cast<Index>(result.target.size()));
  }
}

// The graph whose nodes are the `count` sets of nodes with equal numbers, still without lengths. Border lengths
// and capacities add up; curvatures are averaged along the borders.
inline Weighted_dual_graph contract(const Weighted_dual_graph& graph,
                           const std::vector<Weighted_dual_graph::Index>& number,
                           Weighted_dual_graph::Index count)
{
  using Index = Weighted_dual_graph::Index;
  Weighted_dual_graph result;
  result.length_of_angle = graph.length_of_angle;
  const Index_groups sets(number, count);
  merge_nodes(graph, sets, result);
  merge_arcs(graph, number, sets, result);
  for (Index arc = 0; arc < result.curvature.size(); ++arc)
    if (result.border_length[arc] > 0)
      result.curvature[arc] /= result.border_length[arc];
  return result;
}

// The distances between the centres of neighbouring nodes.
inline std::vector<float> lengths_between_centres(const Weighted_dual_graph& graph)
{
  using Index = Weighted_dual_graph::Index;
  std::vector<float> lengths;
  lengths.reserve(graph.target.size());
  for (Index u = 0; u < graph.number_of_nodes(); ++u)
    for (Index arc : graph.arcs(u))
    {
      const Indexed_surface::Vector_3 step = graph.centre_of(graph.target[arc]) - graph.centre_of(u);
      lengths.push_back(static_cast<float>((std::max)(std::sqrt(step.squared_length()), 1e-9)));
    }
  return lengths;
}

// Contracts a graph to about `number_of_nodes` nodes of similar area that do not straddle seams: the
// structure of a shape does not depend on how finely it is meshed, so the search for cuts need not either. `tie` is what
// holds neighbours together.
inline Coarse_graph coarsen(const Weighted_dual_graph& graph,
                            Weighted_dual_graph::Index number_of_nodes,
                            Execution& execution,
                            std::vector<float> Weighted_dual_graph::*tie = &Weighted_dual_graph::capacity)
{
  using Index = Weighted_dual_graph::Index;
  // twice the mean; larger nodes would hide narrow protrusions
  const double largest_area = 2. / number_of_nodes;
  // a round that merges less than this share of the nodes is the last
  constexpr double least_progress = 0.02;
  Coarse_graph result;
  result.node.resize(graph.number_of_nodes());
  std::iota(result.node.begin(), result.node.end(), Index(0));
  const Weighted_dual_graph* current = &graph; // never a copy: it would be the largest array of a segmentation
  while (current->number_of_nodes() > number_of_nodes)
  {
    execution.check();
    const Index before = current->number_of_nodes();
    const auto match = match_neighbors(*current, current->*tie, largest_area, before - number_of_nodes);
    if (before - match.second < least_progress * before && before < 2 * number_of_nodes)
      break;
    if (match.second == before)
      break;
    result.graph = contract(*current, match.first, match.second);
    current = &result.graph;
    for (Index& node : result.node)
      node = match.first[node];
  }
  if (current == &graph)
    result.graph = graph;
  else
    result.graph.length = lengths_between_centres(result.graph);
  return result;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_COARSEN_GRAPH_H
