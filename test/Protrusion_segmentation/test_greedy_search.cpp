// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sets of cuts beside all sets of cuts and beside the greedy choice of all cuts.

#include "all_cuts.h"
#include "check.h"
#include "components.h"
#include "segmentations.h"
#include "segments_of_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Greedy_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

using namespace test_meshes;
using internal::Cut_set;
using internal::Nodes;

constexpr double rounding = 1e-12;

// Every segment that may matter at all is searched, and cuts are made one at a time.
Cut_options thorough_options()
{
  Cut_options options;
  options.sure_log_odds = infinity;
  options.largest_relative_value = 0.5;
  options.least_protrusion = -infinity;
  return options;
}

// Every cut splits a segment that there is, and the values add up.
void check_history(const internal::Component& component, const Cut_set& set)
{
  std::set<Index> segments = {0};
  double value = 0;
  for (const Cut_set::Made_cut& cut : set.cuts)
  {
    CGAL_CHECK_EQUAL(segments.erase(cut.segment), 1);
    segments.insert(cut.inner);
    segments.insert(cut.outer);
    value += cut.value;
    CGAL_CHECK_EQUAL(component.memo()[cut.inner].segment.nodes.size() +
                  component.memo()[cut.outer].segment.nodes.size(),
                component.memo()[cut.segment].segment.nodes.size());
  }
  CGAL_CHECK_CLOSE(set.value, value, rounding);
  CGAL_CHECK(std::vector<Index>(segments.begin(), segments.end()) == set.segments);
}

// Whatever numbers the segments have: those that are left, in the order in which cuts have made them.
void check_order(const Cut_set& set)
{
  std::vector<Index> made = {0};
  for (const Cut_set::Made_cut& cut : set.cuts)
  {
    made.erase(std::find(made.begin(), made.end(), cut.segment));
    made.push_back(cut.inner);
    made.push_back(cut.outer);
  }
  CGAL_CHECK(set.in_order_of_cuts() == made);
}

void check_sets(const Test_mesh& mesh, std::size_t largest_number)
{
  Component_of_mesh of_mesh(mesh);
  internal::Component& component = of_mesh.component;
  std::size_t number = 1;
  for (; number <= largest_number && component.best(number); ++number)
  {
    const Cut_set set = *component.best(number);
    CGAL_CHECK_EQUAL(set.segments.size(), number);
    CGAL_CHECK_EQUAL(set.cuts.size(), number - 1);
    check_history(component, set);
    check_order(set);
    check_segments(component.graphs().coarse, labels_of_nodes(component, set), number);
  }
  for (std::size_t k = number; k-- > 1;) // asked for again, in another order
    CGAL_CHECK_EQUAL(component.best(k)->segments.size(), k);
}

// As no segment has less than a four hundredth of the area, there is a largest number.
void there_are_no_more_sets_than_there_are_cuts()
{
  for (const Test_mesh& mesh : {tetrahedron(), box(2, 2, 2), icosphere(1)})
  {
    Component_of_mesh of_mesh(mesh);
    CGAL_CHECK(of_mesh.component.best(1) != nullptr);
    CGAL_CHECK(of_mesh.component.best(mesh.faces.size() + 1) == nullptr);
    CGAL_CHECK(of_mesh.component.best(401) == nullptr);
    CGAL_CHECK(of_mesh.component.best(1) != nullptr);
  }
}

// Where the true arms begin.
void the_cuts_of_a_star_are_its_arms(std::size_t arms)
{
  const Test_mesh mesh = star(arms);
  Component_of_mesh of_mesh(mesh);
  const Cut_set set = *of_mesh.component.best(arms + 1);
  std::set<Index> with_arm;
  const std::vector<Index> labels = labels_of_faces(of_mesh.component, set);
  for (std::size_t part = 0; part <= arms; ++part)
  {
    std::vector<double> areas(arms + 1, 0);
    for (std::size_t f = 0; f < labels.size(); ++f)
      areas[labels[f]] += mesh.parts[f] == part ? of_mesh.surface.area(Index(f)) : 0;
    const auto largest = std::max_element(areas.begin(), areas.end());
    CGAL_CHECK(*largest > 0.9 * area_of_part(mesh, part));
    with_arm.insert(Index(largest - areas.begin()));
  }
  CGAL_CHECK_EQUAL(with_arm.size(), arms + 1);
  for (const Cut_set::Made_cut& cut : set.cuts)
    CGAL_CHECK(cut.value > 0);
  CGAL_CHECK(of_mesh.component.best(arms + 2) == nullptr ||
        of_mesh.component.best(arms + 2)->value - set.value < set.cuts.back().value);
}

// Greedy choice finds the best cut, and no set that is worth more than the best one.
void check_values(const Test_mesh& mesh, std::size_t most_cuts)
{
  Component_of_mesh of_mesh(mesh, thorough_options());
  All_cuts all(mesh);
  for (std::size_t cuts = 1; cuts <= most_cuts && of_mesh.component.best(cuts + 1); ++cuts)
  {
    const double found = of_mesh.component.best(cuts + 1)->value, largest = all.largest_value(cuts);
    CGAL_CHECK(found <= largest + rounding);
    if (cuts == 1)
      CGAL_CHECK_CLOSE(found, largest, rounding);
  }
}

std::set<Nodes> nodes_of_segments(const internal::Segment_memo& memo, const Cut_set& set)
{
  std::set<Nodes> result;
  for (const Index s : set.segments)
    result.insert(memo[s].segment.nodes);
  return result;
}

std::size_t number_of_searched_segments(const internal::Segment_memo& memo)
{
  std::size_t number = 0;
  for (Index s = 0; s < memo.number_of_segments(); ++s)
    number += memo[s].is_searched;
  return number;
}

// What is not searched would not have changed anything.
void few_segments_are_searched(const Test_mesh& mesh, std::size_t number_of_cuts)
{
  Component_of_mesh of_mesh(mesh, thorough_options());
  All_cuts all(mesh);
  const std::vector<Cut_set> expected = all.greedy(number_of_cuts);
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const Cut_set* found = of_mesh.component.best(i + 1);
    CGAL_CHECK(found != nullptr);
    if (!found)
      return;
    CGAL_CHECK_CLOSE(found->value, expected[i].value, rounding);
    CGAL_CHECK(nodes_of_segments(of_mesh.component.memo(), *found) ==
          nodes_of_segments(all.memo(), expected[i]));
  }
  const std::size_t searched = number_of_searched_segments(of_mesh.component.memo());
  CGAL_CHECK(searched <= number_of_searched_segments(all.memo()));
  Component_of_mesh usual(mesh);
  usual.component.automatic_number();
  CGAL_CHECK(number_of_searched_segments(usual.component.memo()) < searched); // small ones are no protrusions
}

// The same sets come up until a cut gains too little, with less work; cuts that gain less may still be asked for.
void sets_end_where_cuts_gain_little(const Test_mesh& mesh, double least_gain)
{
  Cut_options options;
  options.least_protrusion = least_gain;
  options.largest_relative_value = 0.5; // a true bound: no segment is left out that has a better cut than expected
  const Indexed_surface surface = to_surface(mesh);
  const std::optional<internal::Any_distance> distance;
  const internal::Graphs_of_surface graphs(surface, options, quiet_execution());
  internal::Segment_search search(surface, graphs, distance, options, quiet_execution());
  internal::Greedy_search limited(graphs.coarse, search, options),
    unlimited(graphs.coarse, search, options);
  std::size_t number = 1;
  for (; limited.best_protrusions(number + 1); ++number)
    CGAL_CHECK(limited.gain_of_last(number + 1) > least_gain);
  CGAL_CHECK(number > 1);
  for (std::size_t k = 1; k <= number; ++k)
    CGAL_CHECK_EQUAL(limited.best(k)->value, unlimited.best(k)->value);
  const std::size_t searched = number_of_searched_segments(limited.memo());
  const Cut_set* next = unlimited.best(number + 1);
  CGAL_CHECK(!next || next->value - unlimited.best(number)->value <= least_gain);
  CGAL_CHECK(searched <= number_of_searched_segments(unlimited.memo()));
  if (next)
    CGAL_CHECK_EQUAL(limited.best(number + 1)->value, next->value);
}

// Asked for at once or one after the other, with the automatic number in between or not.
void sets_do_not_depend_on_what_was_asked_before(const Test_mesh& mesh)
{
  constexpr std::size_t most = 10;
  Component_of_mesh one_by_one(mesh), at_once(mesh), automatic(mesh);
  automatic.component.automatic_number();
  at_once.component.best(most);
  for (std::size_t k = 1; k <= most && one_by_one.component.best(k); ++k)
    for (internal::Component* other : {&at_once.component, &automatic.component})
    {
      const Cut_set* found = other->best(k);
      CGAL_CHECK(found != nullptr);
      if (!found)
        continue;
      CGAL_CHECK_EQUAL(found->value, one_by_one.component.best(k)->value);
      CGAL_CHECK(nodes_of_segments(other->memo(), *found) ==
            nodes_of_segments(one_by_one.component.memo(), *one_by_one.component.best(k)));
    }
}

// Each made set has one sure cut more than the one before, in what the earlier ones have left. A side that is cut off is whole in the
// segment where the cut was found.
void sure_cuts_leave_each_other_alone(const Test_mesh& mesh, std::size_t least_number)
{
  const Cut_options options;
  const Indexed_surface surface = to_surface(mesh);
  const std::optional<internal::Any_distance> distance;
  const internal::Graphs_of_surface graphs(surface, options, quiet_execution());
  internal::Segment_search search(surface, graphs, distance, options, quiet_execution());
  internal::Segment_memo memo(graphs.coarse);
  Cut_set whole;
  whole.segments.push_back(memo.find_or_add(all_nodes(graphs.coarse)));
  memo.set_cuts(0, search(memo[0].segment));
  internal::Sure_cuts sure_cuts(graphs.coarse, memo, options);
  const std::vector<Cut_set> sets = sure_cuts(whole, 0);
  CGAL_CHECK(sets.size() >= least_number - 1); // the first one has two cuts
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    CGAL_CHECK_EQUAL(sets[i].cuts.size(), i + 2);
    Index rest = 0;
    double value = 0;
    for (const Cut_set::Made_cut& made : sets[i].cuts)
    {
      CGAL_CHECK_EQUAL(made.segment, rest);
      const auto found = std::find_if(memo[0].cuts.begin(), memo[0].cuts.end(), [&](const internal::Cut& cut)
                                      { return cut.inner == memo[made.inner].segment.nodes; });
      CGAL_CHECK(found != memo[0].cuts.end() && found->log_odds >= options.sure_log_odds);
      value += made.value;
      rest = made.outer;
    }
    CGAL_CHECK_CLOSE(sets[i].value, value, rounding);
    std::vector<Index> labels(graphs.coarse.number_of_nodes(), 0);
    for (std::size_t s = 0; s < sets[i].segments.size(); ++s)
      for (Index node : memo[sets[i].segments[s]].segment.nodes)
        labels[node] = Index(s);
    check_segments(graphs.coarse, labels, i + 3);
  }
}

// The arms of a star without a ball are worth less, one at a time, than a cut through the middle.
void sure_cuts_find_better_sets(std::size_t arms)
{
  const Test_mesh mesh = star_of_equal_arms(arms);
  Cut_options one_at_a_time;
  one_at_a_time.sure_log_odds = infinity;
  Component_of_mesh with(mesh), without(mesh, one_at_a_time);
  CGAL_CHECK(with.component.best(arms + 1)->value > without.component.best(arms + 1)->value);
}

// A ball above a flat base that has arms in its plane: part 0 is the ball with the underside.
Test_mesh body_on_flat_base(std::size_t arms, double height)
{
  std::vector<Stick> sticks = {ball({0, 0, height}, 0.8, 0)};
  for (std::size_t i = 0; i < arms; ++i)
  {
    const double turn = 2 * pi * double(i) / double(arms);
    sticks.push_back({{0, 0, 0.1}, {2 * std::cos(turn), 2 * std::sin(turn), 0.1}, 0.25, 0.25, i + 1});
  }
  Test_mesh mesh = implicit_mesh(Implicit_body(sticks, 0.03), 0.12);
  for (Point& p : mesh.points)
    p[2] = (std::max)(0., p[2]);
  return mesh;
}

// Six of these had a segment that was the underside alone.
void undersides_are_no_segments()
{
  for (double height : {0.7, 0.75})
    for (std::size_t arms = 4; arms <= 8; ++arms)
    {
      const Test_mesh mesh = body_on_flat_base(arms, height);
      const Segmentation found = automatic_segmentation(mesh);
      CGAL_CHECK_EQUAL(found.number, arms + 1);
      CGAL_CHECK(as_partition(found.labels) == as_partition(given_segmentation(mesh, arms + 1).labels));
    }
}

int main()
{
  for (const Test_mesh& mesh : {star(4), creature(), torus(), bumpy_sphere(3, 1), sheet(20, 30)})
    check_sets(mesh, 12);
  there_are_no_more_sets_than_there_are_cuts();
  for (const std::size_t arms : {1, 3, 6})
    the_cuts_of_a_star_are_its_arms(arms);
  for (const Test_mesh& mesh : {star(3, 2, 0.25, 0.1, 0.4), star(5, 2, 0.25, 0.1, 0.4), creature(0.25), bumpy_sphere(3, 1)})
    check_values(mesh, 3); // a matter of seconds
  for (const Test_mesh& mesh : {star(5), creature(), bumpy_sphere(3, 1)})
  {
    few_segments_are_searched(mesh, 12);
    sets_do_not_depend_on_what_was_asked_before(mesh);
  }
  sure_cuts_leave_each_other_alone(star(6), 6);
  sure_cuts_leave_each_other_alone(star_of_equal_arms(6), 5);
  sure_cuts_leave_each_other_alone(creature(), 2);
  sure_cuts_leave_each_other_alone(torus(), 1); // none
  sure_cuts_find_better_sets(6);
  sure_cuts_find_better_sets(8);
  for (const double least_gain : {0.01, 0.02, 0.05})
    for (const Test_mesh& mesh : {star(5), creature()})
      sets_end_where_cuts_gain_little(mesh, least_gain);
  undersides_are_no_segments();
  return check::result();
}
