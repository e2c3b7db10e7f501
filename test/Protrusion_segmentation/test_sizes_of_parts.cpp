// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sizes of what cuts separate, with what was cut off before.

#include "check.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut/Sizes_of_parts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace test_meshes;

namespace {

using namespace CGAL::Protrusion_segmentation::internal;

// Nodes 0 to n - 1 in a row, node i of area i + 1; of a ring the last one is next to the first.
Seam_graph row(Index n, bool is_ring)
{
  Seam_graph graph;
  for (Index i = 0; i < n; ++i)
  {
    if (i > 0 || is_ring)
      graph.target.push_back((i + n - 1) % n);
    if (i + 1 < n || is_ring)
      graph.target.push_back((i + 1) % n);
    graph.first_arc.push_back(static_cast<Index>(graph.target.size()));
    graph.area.push_back(i + 1);
  }
  return graph;
}

// The sizes of the parts of the cuts around some sides of a segment, each surer than the one before.
std::vector<Size_of_part> sizes(const Seam_graph& graph, const Nodes& segment, const std::vector<Nodes>& sides)
{
  std::vector<Cut> cuts;
  for (const Nodes& side : sides)
  {
    Cut cut;
    cut.inner = side;
    cut.clues.relative_length = 0.5;
    cut.clues.thickness = -0.25;
    cut.log_odds = static_cast<double>(cuts.size());
    cuts.push_back(cut);
  }
  Graph_partition partition(graph);
  const Segment all = {segment, graph.area_of(segment)};
  Sizes_of_parts(partition, Cut_weights(), all)(cuts);
  std::vector<Size_of_part> result;
  for (const Cut& cut : cuts)
    result.push_back(cut.size);
  return result;
}

double area_of_part(const Seam_graph& graph, const Nodes& segment, const Nodes& side)
{
  return std::exp(sizes(graph, segment, {side})[0].area);
}

std::vector<bool> are_repeated(const Seam_graph& graph, const Nodes& segment, const std::vector<Nodes>& sides)
{
  std::vector<bool> result;
  for (const Size_of_part& size : sizes(graph, segment, sides))
    result.push_back(size.is_repeated);
  return result;
}

// Ten nodes, of area 55.
void what_was_cut_off_before_belongs_to_the_part()
{
  const Seam_graph graph = row(10, false);
  CGAL_CHECK_CLOSE(area_of_part(graph, all_nodes(graph), {0, 1, 2}), 6, 1e-12);
  CGAL_CHECK_CLOSE(area_of_part(graph, {2, 3, 4, 5}, {2, 3}), 10, 1e-12);
  CGAL_CHECK_CLOSE(area_of_part(graph, {2, 3, 4, 5}, {4, 5}), 10, 1e-12); // 45 with the rest: the other side is the part
  CGAL_CHECK_CLOSE(area_of_part(graph, {7, 8, 9}, {7}), 19, 1e-12);
  CGAL_CHECK_CLOSE(area_of_part(graph, {7, 8, 9}, {9}), 10, 1e-12);
}

// The rest of a ring is next to both sides and belongs to neither.
void the_rest_of_a_ring_belongs_to_no_part()
{
  const Seam_graph graph = row(10, true);
  CGAL_CHECK_CLOSE(area_of_part(graph, {2, 3, 4, 5}, {2, 3}), 7, 1e-12);
  CGAL_CHECK_CLOSE(area_of_part(graph, {2, 3, 4, 5}, {3}), 4, 1e-12);
}

void length_and_thickness_are_those_of_the_cut()
{
  const Size_of_part size = sizes(row(10, false), {2, 3, 4, 5}, {{2, 3}})[0];
  CGAL_CHECK_CLOSE(size.length, 0.5 + std::log(7) / 2, 1e-12); // relative to the root of the area of the inner side
  CGAL_CHECK_EQUAL(size.thickness, -0.25);
}

// A band around the foot of a leg makes no other leg.
void nearly_the_same_part_is_cut_off_once()
{
  const Seam_graph graph = row(10, false);
  using Answers = std::vector<bool>;
  CGAL_CHECK((are_repeated(graph, all_nodes(graph), {{0, 1, 2, 3, 4}, {0, 1, 2, 3, 4, 5}}) == Answers{true, false})); // 15, 21
  CGAL_CHECK((are_repeated(graph, all_nodes(graph), {{0, 1, 2}, {0, 1, 2, 3, 4, 5}}) == Answers{false, false}));       // 6, 21
  CGAL_CHECK((are_repeated(graph, all_nodes(graph), {{0, 1, 2, 3, 4, 5}, {8, 9}}) == Answers{false, false})); // 21, 19, elsewhere
  CGAL_CHECK((are_repeated(graph, {5, 6, 7, 8, 9}, {{5}, {5, 6}}) == Answers{true, false}));    // 21 behind 15, 27 beside it
  CGAL_CHECK((are_repeated(graph, {0, 1, 2, 3, 4}, {{0, 1, 2, 3}, {0, 1}}) == Answers{true, false})); // 10 and 3 of 15
  CGAL_CHECK((are_repeated(graph, {1, 2, 3, 4, 5, 6}, {{1}, {1, 2, 3}}) == Answers{false, false})); // 3 and 10 behind 1
}

// A side grows by the nodes that are reached from it, but not from the other one.
void sides_grow_by_what_is_reached_from_them_alone(std::uint_fast32_t seed)
{
  const Seam_graph graph = seam_graph(random_surface(seed));
  Random random(seed);
  Graph_partition partition(graph);
  const auto some_nodes = [&](double share)
  {
    std::vector<bool> taken(graph.number_of_nodes());
    for (std::size_t i = 0; i < taken.size(); ++i)
      taken[i] = random.real(0, 1) < share;
    return taken;
  };
  const std::vector<bool> in_segment = some_nodes(0.6), in_inner = some_nodes(0.5);
  Nodes segment, inner;
  double sides[2] = {0, 0};
  for (const Index i : all_nodes(graph))
    if (in_segment[i])
    {
      segment.push_back(i);
      sides[in_inner[i]] += graph.area[i];
      if (in_inner[i])
        inner.push_back(i);
    }
  if (inner.empty() || inner.size() == segment.size())
    return;
  for (const Index i : all_nodes(graph))
    if (!in_segment[i])
    {
      bool touches[2] = {false, false};
      for (const Index j : partition.connected_nodes(i, [&](Index k) { return !in_segment[k]; }))
        for (const Index arc : graph.arcs(j))
          if (const Index k = graph.target[arc]; in_segment[k])
            touches[in_inner[k]] = true;
      for (const bool side : {false, true})
        if (touches[side] && !touches[!side])
          sides[side] += graph.area[i];
    }
  CGAL_CHECK_CLOSE(area_of_part(graph, segment, inner), (std::min)(sides[0], sides[1]), 1e-6);
}

} // namespace

int main()
{
  what_was_cut_off_before_belongs_to_the_part();
  the_rest_of_a_ring_belongs_to_no_part();
  length_and_thickness_are_those_of_the_cut();
  nearly_the_same_part_is_cut_off_once();
  for (std::uint_fast32_t seed = 0; seed < 50; ++seed)
    sides_grow_by_what_is_reached_from_them_alone(seed);
  return check::result();
}
