// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments that are found again by their nodes, and sets of cuts of them.

#include "check.h"
#include "distinct_cuts.h"
#include "dual_graphs.h"
#include "node_sets.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Segment_memo.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Cut_set;
using internal::Nodes;
using internal::Segment_memo;

// Random sides of a segment.
std::vector<internal::Cut> random_cuts(const Nodes& nodes, Random& random)
{
  std::vector<internal::Cut> cuts;
  for (std::size_t c = 0; c < 4; ++c)
  {
    const double share = random.real(0.02, 0.5);
    internal::Cut cut;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(cut.inner),
                 [&](Index) { return random.real(0, 1) < share; });
    cut.value = random.real(-1, 1);
    if (!cut.inner.empty() && cut.inner.size() < nodes.size())
      cuts.push_back(cut);
  }
  internal::sort_best_first(cuts);
  return cuts;
}

// Segments of random cuts of each other, each with the number of its nodes.
void segments_are_found_by_their_nodes(std::uint_fast32_t seed)
{
  const Seam_graph graph = seam_graph(bumpy_sphere(2, seed));
  Random random(seed);
  Segment_memo memo(graph);
  std::map<Nodes, Index> expected;
  expected[all_nodes(graph)] = memo.find_or_add(all_nodes(graph));
  const Segment_memo::Entry* const whole = &memo[0];
  for (Index s = 0; s < memo.number_of_segments() && s < 30; ++s)
  {
    const Nodes nodes = memo[s].segment.nodes;
    CGAL_CHECK_CLOSE(memo[s].segment.area, area_of(graph, Node_set(nodes.begin(), nodes.end())), 1e-12);
    CGAL_CHECK(!memo[s].is_searched && memo[s].cuts.empty());
    const std::vector<internal::Cut> cuts = random_cuts(nodes, random);
    memo.set_cuts(s, cuts);
    CGAL_CHECK(memo[s].is_searched);
    CGAL_CHECK_EQUAL(memo[s].cuts.size(), cuts.size());
    for (const internal::Cut& cut : cuts)
    {
      const Cut_set::Made_cut made = memo.made_cut(s, cut, cut.value);
      CGAL_CHECK_EQUAL(made.segment, s);
      CGAL_CHECK_EQUAL(made.value, cut.value);
      for (const Index side : {made.inner, made.outer})
        CGAL_CHECK_EQUAL(expected.emplace(memo[side].segment.nodes, side).first->second, side);
      CGAL_CHECK(memo[made.inner].segment.nodes == cut.inner);
      CGAL_CHECK(memo[made.outer].segment.nodes == internal::other_side(memo[s].segment, cut.inner));
      CGAL_CHECK_EQUAL(memo.find_or_add(cut.inner), made.inner);
    }
  }
  CGAL_CHECK_EQUAL(expected.size(), memo.number_of_segments());
  CGAL_CHECK(whole == &memo[0]); // others are added, addresses stay
}

// Two arms are cut off in one order and in the other one: what is left is one and the same segment.
void a_segment_is_the_same_in_any_order_of_cuts()
{
  const Seam_graph graph = seam_graph(sheet(10, 10));
  Segment_memo memo(graph);
  const Nodes all = all_nodes(graph);
  const Index whole = memo.find_or_add(all);
  internal::Cut first, second;
  first.inner = Nodes(all.begin(), all.begin() + 30);
  second.inner = Nodes(all.end() - 30, all.end());
  const Cut_set::Made_cut first_of_whole = memo.made_cut(whole, first, first.value),
                          second_of_whole = memo.made_cut(whole, second, second.value);
  const Cut_set::Made_cut second_of_rest = memo.made_cut(first_of_whole.outer, second, second.value);
  const Cut_set::Made_cut first_of_rest = memo.made_cut(second_of_whole.outer, first, first.value);
  CGAL_CHECK_EQUAL(first_of_rest.outer, second_of_rest.outer);
  CGAL_CHECK_EQUAL(memo.number_of_segments(), 6u);
}

// Sets of cuts with equal segments are equal, whatever the order of the cuts; the order of the cuts remains known.
void sets_add_up()
{
  const Cut_set whole = {{0}, {}, 0};
  CGAL_CHECK(whole.in_order_of_cuts() == std::vector<Index>{0});
  const Cut_set set = whole.with({0, 5, 2, 0.5}).with({2, 7, 1, 0.25}).with({5, 3, 4, -0.125});
  CGAL_CHECK((set.segments == std::vector<Index>{1, 3, 4, 7}));
  CGAL_CHECK((set.in_order_of_cuts() == std::vector<Index>{7, 1, 3, 4}));
  CGAL_CHECK_EQUAL(set.value, 0.625);
  CGAL_CHECK_EQUAL(set.cuts.size(), 3u);
}

// The log odds of a cut grow by `like_part` if a part of its size has been cut off before.
void a_part_like_one_cut_off_before_gains_more()
{
  internal::Cut_weights weights;
  weights.like_part = 2;
  internal::Cut cut;
  cut.log_odds = -0.5;
  cut.root_of_areas = 0.25;
  cut.size = {-3, -1, 0.5};
  const auto gain_beside = [&](std::vector<internal::Size_of_part> sizes)
  {
    Cut_set set;
    for (const internal::Size_of_part& size : sizes)
      set.cuts.push_back({0, 0, 0, 1, 1, true, size});
    return set.gain(cut, weights);
  };
  const double alone = 0.25 * std::tanh(-0.25), beside_equal = 0.25 * std::tanh(0.75);
  CGAL_CHECK_CLOSE(gain_beside({}), alone, 1e-15);
  CGAL_CHECK_CLOSE(gain_beside({{-3, -1, 0.5}}), beside_equal, 1e-15);
  CGAL_CHECK_CLOSE(gain_beside({{-1, 0, 0}, {-3, -1, 0.5}, {-3, -1, 1}}), beside_equal, 1e-15); // the most alike decides
  CGAL_CHECK_CLOSE(gain_beside({{-3, -1, 0.5}, {-3, -1, 0.5}}), beside_equal, 1e-15);
  CGAL_CHECK_CLOSE(gain_beside({{-2, -1, 0.5}, {-3, 0, 0.5}, {-3, -1, 1.5}}), alone, 1e-9); // 1 / 2.7 as large in one of its sizes
  for (const internal::Size_of_part& near : {internal::Size_of_part{-3.1, -1, 0.5}, {-3, -0.9, 0.5}, {-3, -1, 0.4}})
    CGAL_CHECK(gain_beside({near}) > alone && gain_beside({near}) < beside_equal);
}

// A cut that marks a place is as sure as that of a part like its own, and `like_part` surer. One that does not is not, nor one that
// even a like part makes no protrusion, nor one whose part is cut off by another.
void a_part_is_as_sure_as_one_like_it()
{
  internal::Cut_weights weights;
  weights.like_part = 1;
  const internal::Size_of_part size = {-3, -1, 0.5};
  const auto evidence = [&](double log_odds, double of_other, internal::Size_of_part other)
  { return internal::evidence_of_part(weights, cut_of({1}, log_odds, size), other, of_other); };
  CGAL_CHECK_CLOSE(evidence(0.5, 3, size), 3.5, 1e-12);
  CGAL_CHECK_CLOSE(evidence(-1, 3, size), 5, 1e-12);
  CGAL_CHECK_CLOSE(evidence(-2.1, 3, size), 1, 1e-12);
  CGAL_CHECK_CLOSE(evidence(3, 0.5, size), 1, 1e-12); // it is surer itself
  CGAL_CHECK_CLOSE(evidence(0.5, 3, {-3.15, -1, 0.5}), 3.5 * std::exp(-0.5), 1e-12);
  internal::Cut anywhere = cut_of({1}, 0.5, size);
  anywhere.clues.widening = 0;
  CGAL_CHECK_CLOSE(internal::evidence_of_part(weights, anywhere, size, 3), 1, 1e-12);
  internal::Cut repeated = cut_of({1}, 0.5, size);
  repeated.size.is_repeated = true;
  CGAL_CHECK_CLOSE(internal::evidence_of_part(weights, repeated, size, 3), 1, 1e-12);
}

int main()
{
  for (std::uint_fast32_t seed = 0; seed < 20; ++seed)
    segments_are_found_by_their_nodes(seed);
  a_segment_is_the_same_in_any_order_of_cuts();
  sets_add_up();
  a_part_like_one_cut_off_before_gains_more();
  a_part_is_as_sure_as_one_like_it();
  return check::result();
}
