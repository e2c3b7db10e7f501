// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sets of cuts beside all sets of cuts and beside the greedy choice.

#include "check.h"
#include "components.h"
#include "segments_of_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/Beam_search.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

using namespace test_meshes;
using internal::Cut_set;
using internal::Nodes;

constexpr double rounding = 1e-12;

// Every segment that may matter at all is searched.
Cut_options thorough_options()
{
  Cut_options options;
  options.largest_relative_value = 0.5;
  options.least_protrusion = -infinity;
  options.searched_at_once = 1;
  return options;
}

// Every cut splits a segment that there is, and the values add up.
void check_history(const internal::Component& component, const Cut_set& set)
{
  std::set<Index> segments = {0};
  double value = 0;
  for (const Cut_set::Made_cut& cut : set.cuts)
  {
    CHECK_EQUAL(segments.erase(cut.segment), 1);
    segments.insert(cut.inner);
    segments.insert(cut.outer);
    value += cut.value;
    CHECK_EQUAL(component.memo()[cut.inner].segment.nodes.size() +
                  component.memo()[cut.outer].segment.nodes.size(),
                component.memo()[cut.segment].segment.nodes.size());
  }
  CHECK_CLOSE(set.value, value, rounding);
  CHECK(std::vector<Index>(segments.begin(), segments.end()) == set.segments);
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
  CHECK(set.in_order_of_cuts() == made);
}

void check_sets(const Test_mesh& mesh, std::size_t largest_number)
{
  Component_of_mesh of_mesh(mesh);
  internal::Component& component = of_mesh.component;
  std::size_t number = 1;
  for (; number <= largest_number && component.best(number); ++number)
  {
    const Cut_set set = *component.best(number);
    CHECK_EQUAL(set.segments.size(), number);
    CHECK_EQUAL(set.cuts.size(), number - 1);
    check_history(component, set);
    check_order(set);
    check_segments(component.graphs().coarse, labels_of_nodes(component, set), number);
  }
  for (std::size_t k = number; k-- > 1;) // asked for again, in another order
    CHECK_EQUAL(component.best(k)->segments.size(), k);
}

// As no segment has less than a four hundredth of the area, there is a largest number.
void there_are_no_more_sets_than_there_are_cuts()
{
  for (const Test_mesh& mesh : {tetrahedron(), box(2, 2, 2), icosphere(1)})
  {
    Component_of_mesh of_mesh(mesh);
    CHECK(of_mesh.component.best(1) != nullptr);
    CHECK(of_mesh.component.best(mesh.faces.size() + 1) == nullptr);
    CHECK(of_mesh.component.best(401) == nullptr);
    CHECK(of_mesh.component.best(1) != nullptr);
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
    CHECK(*largest > 0.9 * area_of_part(mesh, part));
    with_arm.insert(Index(largest - areas.begin()));
  }
  CHECK_EQUAL(with_arm.size(), arms + 1);
  for (const Cut_set::Made_cut& cut : set.cuts)
    CHECK(cut.value > 0);
  CHECK(of_mesh.component.best(arms + 2) == nullptr ||
        of_mesh.component.best(arms + 2)->value - set.value < set.cuts.back().value);
}

// All cuts of any segment, as they are searched, but without a beam.
class All_cuts
{
public:
  explicit All_cuts(const Test_mesh& mesh)
    : m_surface(to_surface(mesh)),
      m_graphs(m_surface, default_options(), quiet_execution()),
      m_search(m_surface, m_graphs, m_distance, default_options(), quiet_execution()),
      m_memo(m_graphs.coarse)
  {
    m_whole.segments.push_back(m_memo.find_or_add(all_nodes(m_graphs.coarse)));
  }

  // The largest value of all sets of that many cuts.
  double largest_value(std::size_t number_of_cuts)
  {
    std::map<std::vector<Index>, Cut_set> sets = {{m_whole.segments, m_whole}};
    for (std::size_t i = 0; i < number_of_cuts; ++i)
      sets = extended(sets);
    double largest = -infinity;
    for (const auto& item : sets)
      largest = (std::max)(largest, item.second.value);
    return largest;
  }

  // Of the best cut of all, again and again.
  double greedy_value(std::size_t number_of_cuts)
  {
    Cut_set set = m_whole;
    for (std::size_t i = 0; i < number_of_cuts; ++i)
    {
      const std::vector<Cut_set> further = with_one_more_cut(set);
      if (further.empty())
        return -infinity;
      set = *std::max_element(further.begin(), further.end(),
                              [](const Cut_set& a, const Cut_set& b) { return a.value < b.value; });
    }
    return set.value;
  }

  // The best one of three sets of cuts that get the best of their four best cuts each, again and again.
  std::vector<Cut_set> best_of_beam(std::size_t number_of_cuts)
  {
    std::vector<Cut_set> beam = {m_whole}, result = {m_whole};
    const auto is_better = [](const Cut_set& a, const Cut_set& b) { return a.value > b.value; };
    while (!beam.empty() && result.size() <= number_of_cuts)
    {
      std::vector<Cut_set> next;
      for (const Cut_set& set : beam)
      {
        std::vector<Cut_set> further = with_one_more_cut(set);
        std::stable_sort(further.begin(), further.end(), is_better);
        further.resize((std::min)(further.size(), std::size_t(4)));
        next.insert(next.end(), further.begin(), further.end());
      }
      std::stable_sort(next.begin(), next.end(), is_better);
      beam.clear();
      for (const Cut_set& set : next)
        if (beam.size() < 3 &&
            std::none_of(beam.begin(), beam.end(),
                         [&](const Cut_set& other) { return other.segments == set.segments; }))
          beam.push_back(set);
      if (!beam.empty())
        result.push_back(beam.front());
    }
    return result;
  }

  const internal::Segment_memo& memo() const { return m_memo; }

private:
  // The better one of sets with the same segments.
  std::map<std::vector<Index>, Cut_set> extended(const std::map<std::vector<Index>, Cut_set>& sets)
  {
    std::map<std::vector<Index>, Cut_set> result;
    for (const auto& item : sets)
      for (const Cut_set& set : with_one_more_cut(item.second))
      {
        const auto [found, is_new] = result.emplace(set.segments, set);
        if (!is_new && found->second.value < set.value)
          found->second = set;
      }
    return result;
  }

  std::vector<Cut_set> with_one_more_cut(const Cut_set& set)
  {
    std::vector<Cut_set> result;
    for (const Index s : set.segments)
      for (const internal::Cut& cut : cuts_of(s))
        result.push_back(set.with(m_memo.made_cut(s, cut)));
    return result;
  }

  const std::vector<internal::Cut>& cuts_of(Index s)
  {
    if (!m_memo[s].is_searched)
      m_memo.set_cuts(s, m_search({&m_memo[s].segment}).front());
    return m_memo[s].cuts;
  }

  Indexed_surface m_surface;
  std::optional<internal::Any_distance> m_distance;
  internal::Graphs_of_surface m_graphs;
  internal::Segment_search m_search;
  internal::Segment_memo m_memo;
  Cut_set m_whole;
};

// Up to two cuts, the beam loses nothing on these shapes. With more it may, but is no worse than the greedy choice.
void check_values(const Test_mesh& mesh, std::size_t largest_number)
{
  constexpr std::size_t most_cuts_of_all = 3; // a matter of seconds
  Component_of_mesh of_mesh(mesh, thorough_options());
  All_cuts all(mesh);
  for (std::size_t cuts = 1; cuts < largest_number && of_mesh.component.best(cuts + 1); ++cuts)
  {
    const double found = of_mesh.component.best(cuts + 1)->value;
    CHECK(found >= all.greedy_value(cuts) - rounding);
    if (cuts <= most_cuts_of_all)
      CHECK(found <= all.largest_value(cuts) + rounding);
    if (cuts <= 2)
      CHECK_CLOSE(found, all.largest_value(cuts), rounding);
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
  const std::vector<Cut_set> expected = all.best_of_beam(number_of_cuts);
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const Cut_set* found = of_mesh.component.best(i + 1);
    CHECK(found != nullptr);
    if (!found)
      return;
    CHECK_CLOSE(found->value, expected[i].value, rounding);
    CHECK(nodes_of_segments(of_mesh.component.memo(), *found) ==
          nodes_of_segments(all.memo(), expected[i]));
  }
  CHECK(number_of_searched_segments(of_mesh.component.memo()) < number_of_searched_segments(all.memo()));
}

// The same sets come up until a cut gains too little, with less work; cuts that gain less may still be asked for.
void sets_end_where_cuts_gain_little(const Test_mesh& mesh, double least_gain)
{
  Cut_options options;
  options.least_protrusion = least_gain;
  const Indexed_surface surface = to_surface(mesh);
  const std::optional<internal::Any_distance> distance;
  const internal::Graphs_of_surface graphs(surface, options, quiet_execution());
  internal::Segment_search search(surface, graphs, distance, options, quiet_execution());
  internal::Beam_search limited(graphs.coarse, search, options),
    unlimited(graphs.coarse, search, options);
  std::size_t number = 1;
  for (; limited.best_protrusions(number + 1); ++number)
    CHECK(limited.gain(number + 1) > least_gain);
  CHECK(number > 1);
  for (std::size_t k = 1; k <= number; ++k)
    CHECK_EQUAL(limited.best(k)->value, unlimited.best(k)->value);
  const std::size_t searched = number_of_searched_segments(limited.memo());
  const Cut_set* next = unlimited.best(number + 1);
  CHECK(!next || next->value - unlimited.best(number)->value <= least_gain);
  CHECK(searched <= number_of_searched_segments(unlimited.memo()));
  if (next)
    CHECK_EQUAL(limited.best(number + 1)->value, next->value);
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
      CHECK(found != nullptr);
      if (!found)
        continue;
      CHECK_EQUAL(found->value, one_by_one.component.best(k)->value);
      CHECK(nodes_of_segments(other->memo(), *found) ==
            nodes_of_segments(one_by_one.component.memo(), *one_by_one.component.best(k)));
    }
}

int main()
{
  for (const Test_mesh& mesh : {star(4), creature(), torus(), bumpy_sphere(3, 1), sheet(20, 30)})
    check_sets(mesh, 12);
  there_are_no_more_sets_than_there_are_cuts();
  for (const std::size_t arms : {1, 3, 6})
    the_cuts_of_a_star_are_its_arms(arms);
  check_values(star(3, 2, 0.25, 0.1, 0.4), 7);
  check_values(star(5, 2, 0.25, 0.1, 0.4), 10);
  check_values(creature(0.25), 12);
  check_values(bumpy_sphere(3, 1), 8);
  for (const Test_mesh& mesh : {star(5), creature(), bumpy_sphere(3, 1)})
  {
    few_segments_are_searched(mesh, 12);
    sets_do_not_depend_on_what_was_asked_before(mesh);
  }
  for (const double least_gain : {0.01, 0.02, 0.05})
    for (const Test_mesh& mesh : {star(5), creature()})
      sets_end_where_cuts_gain_little(mesh, least_gain);
  return check::result();
}
