// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments that take over the cuts of others: random cuts of random graphs against sets of nodes.

#include "check.h"
#include "indexed_surfaces.h"
#include "node_sets.h"
#include "test_meshes.h"
#include "weighted_dual_graphs.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Segment_pool.h>

#include <numeric>
#include <set>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Segment_pool;
using internal::Weighted_dual_graph;
using Nodes = Segment_pool::Nodes;

Node_set set_of(const Nodes& nodes)
{
  return Node_set(nodes.begin(), nodes.end());
}

Node_set common(const Node_set& a, const Node_set& b)
{
  Node_set result;
  for (const Index i : a)
    if (b.count(i) > 0)
      result.insert(i);
  return result;
}

double overlap(const Weighted_dual_graph& graph, const Node_set& a, const Node_set& b)
{
  Node_set both = a;
  both.insert(b.begin(), b.end());
  return area_of(graph, common(a, b)) / area_of(graph, both);
}

// Random sides of a segment, some of them others with a few nodes more or less.
std::vector<internal::Cut> random_cuts(const Nodes& nodes, Random& random)
{
  std::vector<internal::Cut> cuts;
  for (std::size_t c = 0; c < 6; ++c)
  {
    const double share = random.real(0.02, 0.5);
    const bool repeats = !cuts.empty() && random.index(2) == 0;
    const Node_set other = repeats ? set_of(cuts[random.index(cuts.size())].inner) : Node_set();
    internal::Cut cut;
    for (const Index i : nodes)
      if (repeats ? (other.count(i) > 0) != (random.real(0, 1) < 0.03) : random.real(0, 1) < share)
        cut.inner.push_back(i);
    cut.value = random.real(-1, 1);
    if (!cut.inner.empty() && cut.inner.size() < nodes.size())
      cuts.push_back(cut);
  }
  return cuts;
}

// What the source of a side must be, by the sets of nodes alone.
Index expected_source(const Weighted_dual_graph& graph, Segment_pool& pool, Index segment, std::size_t cut, bool is_inner)
{
  const auto sides = pool.sides(segment, cut);
  const Index side = is_inner ? sides.first : sides.second, source = pool[segment].source;
  if (area_of(graph, set_of(pool[side].nodes)) > 0.9 * area_of(graph, set_of(pool[source].nodes)))
    return source;
  const std::size_t original = pool[segment].originals[cut];
  return original == cut ? side : expected_source(graph, pool, segment, original, is_inner);
}

void check_originals(const Weighted_dual_graph& graph, const Segment_pool::Segment& segment)
{
  for (std::size_t c = 0; c < segment.cuts.size(); ++c)
  {
    const auto is_copy_of = [&](std::size_t other)
    {
      return segment.originals[other] == other &&
             overlap(graph, set_of(segment.cuts[c].inner), set_of(segment.cuts[other].inner)) > 0.8;
    };
    std::size_t expected = 0;
    while (expected < c && !is_copy_of(expected))
      ++expected;
    CHECK_EQUAL(segment.originals[c], expected);
    CHECK(c == 0 || segment.cuts[c - 1].value >= segment.cuts[c].value);
  }
}

void check_sides(const Weighted_dual_graph& graph, Segment_pool& pool, Index segment, std::size_t cut)
{
  const auto [inner, outer] = pool.sides(segment, cut);
  CHECK(pool[inner].nodes == pool[segment].cuts[cut].inner);
  CHECK(pool[outer].nodes == pool.other_side(segment, pool[inner].nodes));
  CHECK(pool.sides(segment, cut) == std::make_pair(inner, outer));
  CHECK_EQUAL(pool[inner].source, expected_source(graph, pool, segment, cut, true));
  CHECK_EQUAL(pool[outer].source, expected_source(graph, pool, segment, cut, false));
  for (const Index side : {inner, outer})
  {
    const Index source = pool[side].source;
    CHECK_EQUAL(pool[source].source, source);
    std::vector<Node_set> expected;
    for (const internal::Cut& of_source : pool[source].cuts)
    {
      const Node_set taken_over = common(set_of(of_source.inner), set_of(pool[side].nodes));
      if (!taken_over.empty() && taken_over.size() < pool[side].nodes.size())
        expected.push_back(taken_over);
    }
    std::vector<Node_set> found;
    for (const Nodes& nodes : pool.sides_to_take_over(side))
      found.push_back(set_of(nodes));
    CHECK(found == expected);
    CHECK(pool.are_same({side, 0}, {0, pool.find_or_add(pool[side].nodes)}));
  }
  CHECK(!pool.are_same({inner}, {outer}));
}

void random_segments_have_the_sources_that_their_cuts_give(std::uint_fast32_t seed)
{
  const Weighted_dual_graph graph = weighted_dual_graph(bumpy_sphere(2, seed));
  Random random(seed);
  Segment_pool pool(graph);
  Nodes all(graph.number_of_nodes());
  std::iota(all.begin(), all.end(), Index(0));
  Index segment = pool.find_or_add(all);
  CHECK_EQUAL(pool.find_or_add(all), segment);
  for (std::size_t step = 0; step < 6 && pool[segment].nodes.size() > 20; ++step)
  {
    if (!pool[segment].is_searched)
      pool.set_cuts(segment, random_cuts(pool[segment].nodes, random));
    check_originals(graph, pool[segment]);
    for (std::size_t c = 0; c < pool[segment].cuts.size(); ++c)
      check_sides(graph, pool, segment, c);
    if (pool[segment].cuts.empty())
      return;
    segment = pool.sides(segment, random.index(pool[segment].cuts.size())).second;
  }
}

// An arm is cut off a body, and another one that is less than a tenth of it: only the first changes the body much.
void a_body_takes_over_its_cuts_until_a_tenth_is_gone()
{
  const Weighted_dual_graph graph = weighted_dual_graph(sheet(10, 10));
  Segment_pool pool(graph);
  Nodes all(graph.number_of_nodes());
  std::iota(all.begin(), all.end(), Index(0));
  const Index whole = pool.find_or_add(all);
  internal::Cut large, small;
  large.inner = Nodes(all.begin(), all.begin() + 30);
  small.inner = Nodes(all.end() - 8, all.end());
  large.value = 2;
  small.value = 1;
  pool.set_cuts(whole, {small, large});
  CHECK(pool[whole].cuts.front().inner == large.inner);
  const auto [arm, body] = pool.sides(whole, 0);
  CHECK_EQUAL(pool[arm].source, arm);
  CHECK_EQUAL(pool[body].source, body);
  const auto [tip, rest] = pool.sides(whole, 1);
  CHECK_EQUAL(pool[tip].source, tip);
  CHECK_EQUAL(pool[rest].source, whole);
  CHECK(pool.sides_to_take_over(rest) == std::vector<Nodes>{large.inner});
}

int main()
{
  for (std::uint_fast32_t seed = 0; seed < 40; ++seed)
    random_segments_have_the_sources_that_their_cuts_give(seed);
  a_body_takes_over_its_cuts_until_a_tenth_is_gone();
  return check::result();
}
