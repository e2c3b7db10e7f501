// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_COARSEN_GRAPH_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_COARSEN_GRAPH_H

#include <CGAL/Protrusion_segmentation/Surface_part.h>
#include <CGAL/Protrusion_segmentation/internal/Seam_graph.h>

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
  Seam_graph graph;
  std::vector<Seam_graph::Index> node;
};

// Pairs every node with the neighbour to which it is tied strongest for its size, small nodes first, as long
// as the pair is no larger than `largest_area`, and no more pairs than `wanted`. Returns for every node the
// number of its pair, and how many there are.
inline std::pair<std::vector<Seam_graph::Index>, Seam_graph::Index> match_neighbors(
  const Seam_graph& graph, double largest_area, Seam_graph::Index wanted)
{
  using Index = Seam_graph::Index;
  const Index n = graph.number_of_nodes();
  const Index unmatched = Surface_part::no_face();
  std::vector<Index> partner(n, unmatched), by_area(n);
  std::iota(by_area.begin(), by_area.end(), Index(0));
  std::sort(by_area.begin(), by_area.end(), [&](Index a, Index b)
            { return graph.area[a] != graph.area[b] ? graph.area[a] < graph.area[b] : a < b; });
  Index pairs = 0;
  for (Index i : by_area)
  {
    if (partner[i] != unmatched || pairs == wanted)
      continue;
    double strongest = -1;
    for (Index arc : graph.arcs(i))
    {
      const Index j = graph.target[arc];
      if (j == i || partner[j] != unmatched || graph.area[i] + graph.area[j] > largest_area)
        continue;
      const double area = graph.area[i] * graph.area[j];
      const double tie = graph.capacity[arc] * static_cast<double>(graph.capacity[arc]);
      const double strength = area > 0 ? tie / area : (std::numeric_limits<double>::max)();
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

// The graph whose nodes are the sets of nodes with equal numbers. Border lengths and capacities add up.
// Curvatures are averaged along the borders; lengths are those between the new centres.
inline Seam_graph contract(const Seam_graph& graph,
                           const std::vector<Seam_graph::Index>& number,
                           Seam_graph::Index count)
{
  using Index = Seam_graph::Index;
  using Vector_3 = Surface_part::Vector_3;
  const Surface_part::Point_3 origin(0, 0, 0);
  Seam_graph result;
  result.area.assign(count, 0);
  std::vector<Vector_3> moment(count, Vector_3(0, 0, 0));
  std::vector<Index> first_member(count + 1, 0), members(graph.number_of_nodes());
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
  {
    result.area[number[i]] += graph.area[i];
    moment[number[i]] += graph.area[i] * (graph.centre[i] - origin);
    ++first_member[number[i] + 1];
  }
  std::partial_sum(first_member.begin(), first_member.end(), first_member.begin());
  std::vector<Index> position(first_member.begin(), first_member.end() - 1);
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    members[position[number[i]]++] = i;
  for (Index u = 0; u < count; ++u)
    result.centre.push_back(result.area[u] > 0 ? origin + moment[u] / result.area[u]
                                               : graph.centre[members[first_member[u]]]);

  std::vector<Index> arc_to(count, Surface_part::no_face()); // the arc to a node, if it leaves this node
  for (Index u = 0; u < count; ++u)
  {
    const Index begin = result.first_arc.back();
    for (Index m = first_member[u]; m < first_member[u + 1]; ++m)
      for (Index old : graph.arcs(members[m]))
      {
        const Index v = number[graph.target[old]];
        if (v == u)
          continue;
        Index& arc = arc_to[v];
        if (arc == Surface_part::no_face() || arc < begin)
        {
          arc = static_cast<Index>(result.target.size());
          result.target.push_back(v);
          result.border_length.push_back(0);
          result.concave_border.push_back(0);
          result.capacity.push_back(0);
          result.curvature.push_back(0);
        }
        result.border_length[arc] += graph.border_length[old];
        result.concave_border[arc] += graph.concave_border[old];
        result.capacity[arc] += graph.capacity[old];
        result.curvature[arc] += graph.curvature[old] * graph.border_length[old];
      }
    result.first_arc.push_back(static_cast<Index>(result.target.size()));
  }
  for (Index u = 0; u < count; ++u)
    for (Index arc : result.arcs(u))
    {
      const Vector_3 step = result.centre[result.target[arc]] - result.centre[u];
      const double length = (std::max)(std::sqrt(step.squared_length()), 1e-9);
      if (result.border_length[arc] > 0)
        result.curvature[arc] /= result.border_length[arc];
      result.length.push_back(static_cast<float>(length));
      result.concave_length.push_back(concave_length(length, result.curvature[arc]));
    }
  find_opposite_arcs(result);
  return result;
}

// Contracts a graph to about `number_of_nodes` nodes of similar area that do not straddle seams: the
// structure of a shape does not depend on how finely it is meshed, so the search for cuts need not either.
inline Coarse_graph coarsen(Seam_graph graph, Seam_graph::Index number_of_nodes)
{
  using Index = Seam_graph::Index;
  // twice the mean; larger nodes would hide narrow protrusions
  const double largest_area = 2. / number_of_nodes;
  // a round that merges less than this share of the nodes is the last
  constexpr double least_progress = 0.02;
  Coarse_graph result;
  result.node.resize(graph.number_of_nodes());
  std::iota(result.node.begin(), result.node.end(), Index(0));
  while (graph.number_of_nodes() > number_of_nodes)
  {
    const Index before = graph.number_of_nodes();
    const auto match = match_neighbors(graph, largest_area, before - number_of_nodes);
    if (before - match.second < least_progress * before && before < 2 * number_of_nodes)
      break;
    if (match.second == before)
      break;
    graph = contract(graph, match.first, match.second);
    for (Index& node : result.node)
      node = match.first[node];
  }
  result.graph = std::move(graph);
  return result;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_COARSEN_GRAPH_H
