// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sets of cuts beside all sets of cuts and beside the greedy choice, and borders on the faces.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"
#include "validation.h"
#include "weighted_dual_graphs.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Component_cuts.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Face_borders.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Component_cuts;
using internal::Cut_set;
using internal::Graph_partition;
using internal::Weighted_dual_graph;
using Nodes = Graph_partition::Nodes;

constexpr double rounding = 1e-12;

struct Cuts_of_mesh
{
  explicit Cuts_of_mesh(const Test_mesh& mesh, const internal::Cut_policy& policy = internal::default_cut_policy())
    : surface(to_surface(mesh)), cuts(surface, distance, quiet_execution(), policy)
  {}

  Indexed_surface surface;
  std::optional<internal::Any_distance> distance;
  Component_cuts cuts;
};

// Every segment that may matter at all is searched on its own.
struct Thorough_policy : internal::Cut_policy
{
  double least_overlap_of_copies() const override { return 1; }
  double largest_relative_value() const override { return 0.5; }
};
const Thorough_policy thorough_policy;

// The segment of every node of the coarse graph; every one has just one.
std::vector<Index> labels_of_nodes(const Component_cuts& cuts, const Cut_set& set)
{
  std::vector<Index> labels(cuts.graphs().coarse.graph.number_of_nodes(), Indexed_surface::no_face());
  for (std::size_t s = 0; s < set.segments.size(); ++s)
    for (const Index i : cuts.pool()[set.segments[s]].nodes)
    {
      CHECK_EQUAL(labels[i], Indexed_surface::no_face());
      labels[i] = Index(s);
    }
  CHECK_EQUAL(std::count(labels.begin(), labels.end(), Indexed_surface::no_face()), 0);
  return labels;
}

std::vector<Index> labels_of_faces(const Component_cuts& cuts, const Cut_set& set)
{
  const std::vector<Index> of_nodes = labels_of_nodes(cuts, set);
  std::vector<Index> result;
  for (const Index node : cuts.graphs().coarse.node)
    result.push_back(of_nodes[node]);
  return result;
}

// Every segment has nodes and is connected.
void check_segments(const Weighted_dual_graph& graph,
                    const std::vector<Index>& labels,
                    std::size_t number)
{
  std::vector<std::vector<std::size_t>> neighbors(graph.number_of_nodes());
  for (Index i = 0; i < graph.number_of_nodes(); ++i)
    for (const Index arc : graph.arcs(i))
      neighbors[i].push_back(graph.target[arc]);
  const std::vector<std::size_t> ids(labels.begin(), labels.end());
  CHECK_EQUAL(validation::problem_with_segment_ids(ids, number).value_or("no problem"), "no problem");
  const std::vector<bool> is_on_small_component(ids.size(), false);
  CHECK_EQUAL(internal::problem_with_connectedness(neighbors, is_on_small_component, ids, number).value_or("no problem"),
              "no problem");
}

// Every cut splits a segment that there is, and the values add up.
void check_history(const Component_cuts& cuts, const Cut_set& set)
{
  std::set<Index> segments = {0};
  double value = 0;
  for (const Cut_set::Made_cut& cut : set.cuts)
  {
    CHECK_EQUAL(segments.erase(cut.segment), 1);
    segments.insert(cut.inner);
    segments.insert(cut.outer);
    value += cut.value;
    CHECK_EQUAL(cuts.pool()[cut.inner].nodes.size() + cuts.pool()[cut.outer].nodes.size(),
                cuts.pool()[cut.segment].nodes.size());
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
  Cuts_of_mesh of_mesh(mesh);
  Component_cuts& cuts = of_mesh.cuts;
  std::size_t number = 1;
  for (; number <= largest_number && cuts.best(number); ++number)
  {
    const Cut_set set = *cuts.best(number);
    CHECK_EQUAL(set.segments.size(), number);
    CHECK_EQUAL(set.cuts.size(), number - 1);
    check_history(cuts, set);
    check_order(set);
    check_segments(cuts.graphs().coarse.graph, labels_of_nodes(cuts, set), number);
  }
  for (std::size_t k = number; k-- > 1;) // asked for again, in another order
    CHECK_EQUAL(cuts.best(k)->segments.size(), k);
}

// As no segment has less than a four hundredth of the area, there is a largest number.
void there_are_no_more_sets_than_there_are_cuts()
{
  for (const Test_mesh& mesh : {tetrahedron(), box(2, 2, 2), icosphere(1)})
  {
    Cuts_of_mesh of_mesh(mesh);
    CHECK(of_mesh.cuts.best(1) != nullptr);
    CHECK(of_mesh.cuts.best(mesh.faces.size() + 1) == nullptr);
    CHECK(of_mesh.cuts.best(401) == nullptr);
    CHECK(of_mesh.cuts.best(1) != nullptr);
  }
}

// Where the true arms begin.
void the_cuts_of_a_star_are_its_arms(std::size_t arms)
{
  const Test_mesh mesh = star(arms);
  Cuts_of_mesh of_mesh(mesh);
  const Cut_set set = *of_mesh.cuts.best(arms + 1);
  std::set<Index> with_arm;
  const std::vector<Index> labels = labels_of_faces(of_mesh.cuts, set);
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
  CHECK(of_mesh.cuts.best(arms + 2) == nullptr ||
        of_mesh.cuts.best(arms + 2)->value - set.value < set.cuts.back().value);
}

// All cuts of any segment, as they are searched, but without a beam.
class All_cuts
{
public:
  explicit All_cuts(const Weighted_dual_graph& graph)
    : m_partition(graph, std::vector<Index>(graph.number_of_nodes(), 0)),
      m_search(m_partition, internal::default_cut_policy(), quiet_execution()),
      m_tip_orders(m_partition, quiet_execution()),
      m_pool(graph, 1)
  {
    Nodes all(graph.number_of_nodes());
    std::iota(all.begin(), all.end(), Index(0));
    m_whole.segments.push_back(m_pool.find_or_add(std::move(all)));
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
        if (beam.size() < 3 && std::none_of(beam.begin(), beam.end(), [&](const Cut_set& other)
                                            { return other.segments == set.segments; }))
          beam.push_back(set);
      if (!beam.empty())
        result.push_back(beam.front());
    }
    return result;
  }

  const internal::Segment_pool& pool() const { return m_pool; }

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
      for (std::size_t c = 0; c < cuts_of(s).size(); ++c)
      {
        const internal::Cut& cut = cuts_of(s)[c];
        const auto [inner, outer] = m_pool.sides(s, c);
        result.push_back(set.with({s, inner, outer, cut.value, cut.probability}));
      }
    return result;
  }

  const std::vector<internal::Cut>& cuts_of(Index s)
  {
    if (!m_pool[s].is_searched)
      m_pool.set_own_cuts(s, searched(s));
    return m_pool[s].cuts;
  }

  void select(Index s)
  {
    for (const Index i : m_pool[s].nodes)
      m_partition.set_segment(i, s);
  }

  std::vector<internal::Cut> searched(Index s)
  {
    select(s);
    internal::Cut_search::Candidate_sources sources;
    m_tip_orders.from_all_tips(s, m_pool[s].nodes, [&](Nodes order) { sources.add_order(std::move(order)); });
    return m_search.cuts(s, m_pool[s].nodes, std::move(sources));
  }

  Graph_partition m_partition;
  internal::Cut_search m_search;
  internal::Tip_orders m_tip_orders;
  internal::Segment_pool m_pool;
  Cut_set m_whole;
};

// Up to two cuts, the beam loses nothing on these shapes. With more it may, but is no worse than the greedy choice.
void check_values(const Test_mesh& mesh, std::size_t largest_number)
{
  constexpr std::size_t most_cuts_of_all = 3; // a matter of seconds
  Cuts_of_mesh of_mesh(mesh, thorough_policy);
  All_cuts all(of_mesh.cuts.graphs().coarse.graph);
  for (std::size_t cuts = 1; cuts < largest_number && of_mesh.cuts.best(cuts + 1); ++cuts)
  {
    const double found = of_mesh.cuts.best(cuts + 1)->value;
    CHECK(found >= all.greedy_value(cuts) - rounding);
    if (cuts <= most_cuts_of_all)
      CHECK(found <= all.largest_value(cuts) + rounding);
    if (cuts <= 2)
      CHECK_CLOSE(found, all.largest_value(cuts), rounding);
  }
}

std::set<Nodes> nodes_of_segments(const internal::Segment_pool& pool, const Cut_set& set)
{
  std::set<Nodes> result;
  for (const Index s : set.segments)
    result.insert(pool[s].nodes);
  return result;
}

std::size_t number_of_searched_segments(const internal::Segment_pool& pool)
{
  std::size_t number = 0;
  for (Index s = 0; s < pool.number_of_segments(); ++s)
    number += pool[s].is_searched;
  return number;
}

// What is not searched would not have changed anything.
void few_segments_are_searched(const Test_mesh& mesh, std::size_t number_of_cuts)
{
  Cuts_of_mesh of_mesh(mesh, thorough_policy);
  All_cuts all(of_mesh.cuts.graphs().coarse.graph);
  const std::vector<Cut_set> expected = all.best_of_beam(number_of_cuts);
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const Cut_set* found = of_mesh.cuts.best(i + 1);
    CHECK(found != nullptr);
    if (!found)
      return;
    CHECK_CLOSE(found->value, expected[i].value, rounding);
    CHECK(nodes_of_segments(of_mesh.cuts.pool(), *found) == nodes_of_segments(all.pool(), expected[i]));
  }
  CHECK(number_of_searched_segments(of_mesh.cuts.pool()) < number_of_searched_segments(all.pool()));
}

// What is like another segment takes over its cuts, and needs no tips: the work is less than if it were searched, the value
// nearly the same.
void segments_like_others_are_not_searched(const Test_mesh& mesh, std::size_t number_of_cuts)
{
  constexpr std::size_t runs_of_segment = 13; // one for the first of twelve tips, and one from each of these
  Cuts_of_mesh usual(mesh), thorough(mesh, thorough_policy);
  for (std::size_t k = 1; k <= number_of_cuts + 1 && thorough.cuts.best(k) && usual.cuts.best(k); ++k)
    CHECK_CLOSE(usual.cuts.best(k)->value, thorough.cuts.best(k)->value, 0.05 * thorough.cuts.best(k)->value);
  std::size_t searched_on_their_own = 0, others = 0;
  const internal::Segment_pool& pool = usual.cuts.pool();
  for (Index s = 0; s < pool.number_of_segments(); ++s)
    if (pool[s].is_searched)
      ++(pool[s].source == s ? searched_on_their_own : others);
  CHECK(others > 0);
  CHECK(usual.cuts.number_of_runs() <= runs_of_segment * searched_on_their_own);
  CHECK(usual.cuts.number_of_runs() < thorough.cuts.number_of_runs());
}

// With a limit of what a cut must bring, the same sets come up until one does not, with less work; and what was not worth
// it may still be asked for.
void sets_end_where_cuts_bring_little(const Test_mesh& mesh, double least_gain)
{
  Cuts_of_mesh with_limit(mesh), without_limit(mesh);
  std::size_t number = 1;
  for (; with_limit.cuts.best(number + 1, least_gain); ++number)
    CHECK(with_limit.cuts.best(number + 1)->value - with_limit.cuts.best(number)->value > least_gain);
  CHECK(number > 1);
  for (std::size_t k = 1; k <= number; ++k)
    CHECK_EQUAL(with_limit.cuts.best(k)->value, without_limit.cuts.best(k)->value);
  const std::size_t searched = number_of_searched_segments(with_limit.cuts.pool());
  const Cut_set* next = without_limit.cuts.best(number + 1);
  CHECK(!next || next->value - without_limit.cuts.best(number)->value <= least_gain);
  CHECK(searched <= number_of_searched_segments(without_limit.cuts.pool()));
  if (next)
    CHECK_EQUAL(with_limit.cuts.best(number + 1)->value, next->value);
}

struct Adjustable_policy : internal::Cut_policy
{
  double log_odds(const internal::Cut_clues& clues) const override { return factor * Cut_policy::log_odds(clues); }

  double factor = 1; // above 0, so that no cut becomes a good one
};

// What has been found by other weights, valued anew, gives the sets that are found from scratch; and the first ones again.
void cuts_are_valued_anew(const Test_mesh& mesh, std::size_t largest_number)
{
  Adjustable_policy adjustable;
  Cuts_of_mesh cuts(mesh, adjustable);
  bool differs = false;
  for (const double factor : {1., 0.2, 3., 1.})
  {
    adjustable.factor = factor;
    cuts.cuts.value_anew();
    Adjustable_policy other;
    other.factor = factor;
    Cuts_of_mesh from_scratch(mesh, other), by_default(mesh);
    for (std::size_t k = 1; k <= largest_number; ++k)
    {
      const Cut_set *found = cuts.cuts.best(k), *expected = from_scratch.cuts.best(k);
      CHECK_EQUAL(found != nullptr, expected != nullptr);
      if (!found || !expected)
        break;
      CHECK_EQUAL(found->value, expected->value);
      CHECK(nodes_of_segments(cuts.cuts.pool(), *found) == nodes_of_segments(from_scratch.cuts.pool(), *expected));
      differs = differs || found->value != by_default.cuts.best(k)->value;
    }
  }
  CHECK(differs);
}

double cost_of_borders(const Weighted_dual_graph& graph, const std::vector<Index>& labels)
{
  double cost = 0;
  for (Index f = 0; f < graph.number_of_nodes(); ++f)
    for (const Index arc : graph.arcs(f))
      cost += labels[f] != labels[graph.target[arc]] ? graph.capacity[arc] : 0;
  return cost;
}

void borders_on_faces_keep_the_segments_connected(const Test_mesh& mesh, std::size_t largest_number)
{
  Cuts_of_mesh of_mesh(mesh);
  const Weighted_dual_graph& graph = of_mesh.cuts.graphs().fine;
  for (std::size_t k = 2; k <= largest_number && of_mesh.cuts.best(k); ++k)
  {
    const std::vector<Index> labels = labels_of_faces(of_mesh.cuts, *of_mesh.cuts.best(k));
    check_segments(graph, labels, k);
    internal::Face_borders borders(graph, labels, k);
    CHECK(borders.labels() == labels);
    borders.refine(quiet_execution());
    check_segments(graph, borders.labels(), k);
    CHECK(cost_of_borders(graph, borders.labels()) <= cost_of_borders(graph, labels) * (1 + 1e-6));
  }
}

// Segments of the faces that are nearest to each of some faces.
void random_segments_stay_connected(std::uint_fast32_t seed)
{
  const Test_mesh mesh = random_surface(seed);
  const Weighted_dual_graph graph = weighted_dual_graph(mesh);
  const std::size_t number = 2 + seed % 5;
  if (number_of_components(mesh) > 1 || mesh.faces.size() < number)
    return;
  Graph_partition partition(graph, std::vector<Index>(graph.number_of_nodes(), 0));
  const std::vector<std::size_t> centers = random_permutation(mesh.faces.size(), seed);
  std::vector<double> least(mesh.faces.size(), infinity);
  std::vector<Index> labels(mesh.faces.size());
  for (std::size_t s = 0; s < number; ++s)
  {
    const internal::Nodes_by_distance order = partition.nodes_by_distance(
      Nodes(1, Index(centers[s])), [](Index) { return true; }, graph.lengths());
    for (std::size_t i = 0; i < order.nodes.size(); ++i)
      if (order.distances[i] < least[order.nodes[i]])
      {
        least[order.nodes[i]] = order.distances[i];
        labels[order.nodes[i]] = Index(s);
      }
  }
  check_segments(graph, labels, number);
  internal::Face_borders borders(graph, labels, number);
  borders.refine(quiet_execution());
  check_segments(graph, borders.labels(), number);
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
    segments_like_others_are_not_searched(mesh, 12);
  }
  for (const double least_gain : {0.01, 0.02, 0.05})
    for (const Test_mesh& mesh : {star(5), creature()})
      sets_end_where_cuts_bring_little(mesh, least_gain);
  for (const Test_mesh& mesh : {star(5), creature(), bumpy_sphere(3, 1)})
    cuts_are_valued_anew(mesh, 10);
  for (const Test_mesh& mesh : {star(5), creature(), torus(), bumpy_sphere(3, 1), sheet(20, 30)})
    borders_on_faces_keep_the_segments_connected(mesh, 10);
  for (std::uint_fast32_t seed = 0; seed < 100; ++seed)
    random_segments_stay_connected(seed);
  return check::result();
}
