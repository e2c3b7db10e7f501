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

constexpr double least_overlap = 0.85;

// Of the segments that have been searched on their own, in that order, the one that has most in common with a segment, by the
// sets of nodes alone.
Index expected_source(const Weighted_dual_graph& graph,
                      const Segment_pool& pool,
                      const std::vector<Index>& searched,
                      Index segment)
{
  Index source = segment;
  double largest = least_overlap;
  for (const Index other : searched)
    if (const double o = overlap(graph, set_of(pool[segment].nodes), set_of(pool[other].nodes)); o > largest + 1e-12)
    {
      largest = o;
      source = other;
    }
  return source;
}

void check_sides_to_take_over(const Segment_pool& pool, Index segment)
{
  std::vector<Node_set> expected, found;
  for (const internal::Cut& of_source : pool[pool[segment].source].cuts)
  {
    const Node_set taken_over = common(set_of(of_source.inner), set_of(pool[segment].nodes));
    if (!taken_over.empty() && taken_over.size() < pool[segment].nodes.size())
      expected.push_back(taken_over);
  }
  for (const Nodes& nodes : pool.sides_to_take_over(segment))
    found.push_back(set_of(nodes));
  CHECK(found == expected);
}

void check_sides(Segment_pool& pool, Index segment, std::size_t cut)
{
  const auto [inner, outer] = pool.sides(segment, cut);
  CHECK(pool[inner].nodes == pool[segment].cuts[cut].inner);
  CHECK(pool[outer].nodes == pool.other_side(segment, pool[inner].nodes));
  CHECK(pool.sides(segment, cut) == std::make_pair(inner, outer));
  CHECK_EQUAL(pool.find_or_add(pool[outer].nodes), outer);
}

// Cuts of a segment, its own or others: the best first.
void check_order_of_cuts(const Segment_pool& pool, Index segment, std::size_t number)
{
  CHECK(pool[segment].is_searched);
  CHECK_EQUAL(pool[segment].cuts.size(), number);
  for (std::size_t c = 1; c < number; ++c)
    CHECK(pool[segment].cuts[c - 1].value >= pool[segment].cuts[c].value);
}

// Segments of random cuts of each other are searched one after the other.
void segments_take_over_from_what_is_most_like_them(std::uint_fast32_t seed)
{
  const Weighted_dual_graph graph = weighted_dual_graph(bumpy_sphere(2, seed));
  Random random(seed);
  Segment_pool pool(graph, least_overlap);
  Nodes all(graph.number_of_nodes());
  std::iota(all.begin(), all.end(), Index(0));
  const Index whole = pool.find_or_add(all);
  CHECK_EQUAL(pool.find_or_add(all), whole);
  std::vector<Index> searched;
  std::size_t taken_over = 0;
  for (Index segment = whole; segment < pool.number_of_segments() && segment < 40; ++segment)
  {
    CHECK_EQUAL(pool[segment].is_searched, false);
    const Index source = pool.find_source(segment);
    CHECK_EQUAL(source, expected_source(graph, pool, searched, segment));
    CHECK_EQUAL(pool[segment].source, source);
    check_sides_to_take_over(pool, segment);
    std::vector<internal::Cut> cuts = random_cuts(pool[segment].nodes, random);
    const std::size_t number = cuts.size();
    if (source == segment)
    {
      pool.set_own_cuts(segment, std::move(cuts));
      searched.push_back(segment);
    }
    else
    {
      pool.take_over(segment, std::move(cuts));
      ++taken_over;
    }
    check_order_of_cuts(pool, segment, number);
    for (std::size_t c = 0; c < number; ++c)
      check_sides(pool, segment, c);
  }
  CHECK(searched.size() > 1 && taken_over > 0);
}

// With a least overlap of 1 nothing is like anything.
void every_segment_can_be_searched()
{
  const Weighted_dual_graph graph = weighted_dual_graph(sheet(10, 10));
  Segment_pool pool(graph, 1);
  Nodes all(graph.number_of_nodes());
  std::iota(all.begin(), all.end(), Index(0));
  pool.set_own_cuts(pool.find_or_add(all), {});
  const Index nearly_all = pool.find_or_add(Nodes(all.begin() + 1, all.end()));
  CHECK_EQUAL(pool.find_source(nearly_all), nearly_all);
}

// Two arms are cut off in one order and in the other one; what is left is the same body but for a node.
void a_body_takes_over_whatever_way_it_came_about()
{
  const Weighted_dual_graph graph = weighted_dual_graph(sheet(10, 10));
  Segment_pool pool(graph, least_overlap);
  Nodes all(graph.number_of_nodes());
  std::iota(all.begin(), all.end(), Index(0));
  const Index whole = pool.find_or_add(all);
  internal::Cut first_arm, second_arm, in_body;
  first_arm.inner = Nodes(all.begin(), all.begin() + 30);
  second_arm.inner = Nodes(all.end() - 31, all.end());
  in_body.inner = Nodes(all.begin() + 30, all.begin() + 50);
  pool.set_own_cuts(whole, {first_arm, second_arm});
  const Index without_first = pool.sides(whole, 0).second, without_second = pool.sides(whole, 1).second;
  CHECK_EQUAL(pool.find_source(without_first), without_first); // a third is gone
  second_arm.inner = Nodes(all.end() - 30, all.end());
  pool.set_own_cuts(without_first, {second_arm});
  pool.set_own_cuts(without_second, {first_arm});
  const Index body = pool.sides(without_first, 0).second, same_body = pool.sides(without_second, 0).second;
  pool.set_own_cuts(body, {in_body});
  CHECK_EQUAL(pool.find_source(same_body), body);
  CHECK(pool.sides_to_take_over(same_body) == std::vector<Nodes>{in_body.inner});
}

// What was found in segments is kept, what they took over is not; and nothing counts as searched.
void a_pool_begins_again()
{
  const Weighted_dual_graph graph = weighted_dual_graph(sheet(10, 10));
  Segment_pool pool(graph, least_overlap);
  Nodes all(graph.number_of_nodes());
  std::iota(all.begin(), all.end(), Index(0));
  const Index whole = pool.find_or_add(all);
  internal::Cut cut;
  cut.inner = Nodes(all.begin(), all.begin() + 8);
  cut.value = 1;
  pool.set_own_cuts(whole, {cut});
  const Index rest = pool.sides(whole, 0).second;
  CHECK_EQUAL(pool.find_source(rest), whole);
  pool.take_over(rest, {cut});
  pool.begin_again([](internal::Cut& c) { c.value = 2; });
  for (const Index segment : {whole, rest})
  {
    CHECK(!pool[segment].is_searched);
    CHECK(pool[segment].cuts.empty());
    CHECK_EQUAL(pool.find_source(segment), segment);
    CHECK_EQUAL(pool[segment].own_cuts.has_value(), segment == whole);
  }
  CHECK_EQUAL(pool[whole].own_cuts->front().value, 2);
}

int main()
{
  for (std::uint_fast32_t seed = 0; seed < 40; ++seed)
    segments_take_over_from_what_is_most_like_them(seed);
  every_segment_can_be_searched();
  a_body_takes_over_whatever_way_it_came_about();
  a_pool_begins_again();
  return check::result();
}
