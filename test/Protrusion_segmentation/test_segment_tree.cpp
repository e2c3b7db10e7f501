// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which segment is the body, and what sticks out of what: on trees against brute force, and on the true parts of shapes.

#include "check.h"
#include "implicit_mesh.h"
#include "test_meshes_bodies.h"
#include "test_meshes_transformations.h"

#include <CGAL/Protrusion_segmentation/internal/Segments/Segment_tree.h>

#include <set>

using namespace test_meshes;
using CGAL::Protrusion_segmentation::internal::Segment_tree;
using Index = Segment_tree::Index;
using Areas = std::vector<double>;
using Lengths = Segment_tree::Lengths;
using Parents = std::vector<Index>;

Parents parents_of(const Segment_tree& tree, std::size_t number_of_segments)
{
  Parents result;
  for (Index s = 0; s < number_of_segments; ++s)
    result.push_back(tree.parent(s));
  return result;
}

// The segments on the side of `from` without the border to `other`.
std::set<Index> side_of(Index from, Index other, const Lengths& lengths)
{
  std::set<Index> side = {from};
  for (std::size_t size = 0; size < side.size();)
  {
    size = side.size();
    for (const auto& [border, length] : lengths)
      if (border != std::pair<Index, Index>(std::minmax(from, other)) &&
          side.count(border.first) != side.count(border.second))
        side.insert({border.first, border.second});
  }
  return side;
}

double sum_over(const std::set<Index>& segments, const Areas& areas)
{
  double sum = 0;
  for (const Index s : segments)
    sum += areas[s];
  return sum;
}

// Of borders that are a tree, with areas whose sums are exact, so that halves are.
void check_tree(const Areas& areas, const Lengths& lengths)
{
  const Segment_tree tree(areas, lengths);
  const double whole = std::accumulate(areas.begin(), areas.end(), 0.);
  CGAL_CHECK_EQUAL(tree.parent(tree.body()), tree.body());
  CGAL_CHECK_EQUAL(tree.area_beyond(tree.body()), whole);
  for (Index s = 0; s < areas.size(); ++s)
  {
    if (s == tree.body())
      continue;
    CGAL_CHECK_EQUAL(lengths.count(std::minmax(s, tree.parent(s))), 1u);
    const std::set<Index> beyond = side_of(s, tree.parent(s), lengths);
    CGAL_CHECK(beyond.count(tree.body()) == 0 && beyond.count(tree.parent(s)) == 0);
    CGAL_CHECK_EQUAL(tree.area_beyond(s), sum_over(beyond, areas));
    CGAL_CHECK(2 * tree.area_beyond(s) <= whole);
  }
}

void a_single_segment_is_the_body()
{
  check_tree({3}, {});
  CGAL_CHECK_EQUAL(Segment_tree({3}, {}).body(), 0);
}

void the_body_of_a_path_holds_its_middle()
{
  const Lengths path = {{{0, 1}, 1}, {{1, 2}, 1}, {{2, 3}, 1}, {{3, 4}, 1}};
  CGAL_CHECK_EQUAL(Segment_tree({1, 1, 1, 1, 1}, path).body(), 2);
  CGAL_CHECK_EQUAL(Segment_tree({1, 1, 1, 1, 7}, path).body(), 4);
  CGAL_CHECK_EQUAL(Segment_tree({1, 1, 1, 4, 2}, path).body(), 3);
  for (const Areas& areas : {Areas{1, 1, 1, 1, 1}, {1, 1, 1, 1, 7}, {1, 1, 1, 4, 2}, {7, 1, 0, 1, 1}})
    check_tree(areas, path);
}

// Whatever the number of the centre.
void the_centre_of_a_star_is_the_body_unless_an_arm_is_larger_than_the_rest()
{
  constexpr Index arms = 6;
  for (Index centre = 0; centre <= arms; ++centre)
  {
    Lengths lengths;
    for (Index s = 0; s <= arms; ++s)
      if (s != centre)
        lengths[std::minmax(s, centre)] = 1 + double(s % 3);
    Areas areas(arms + 1, 1);
    areas[centre] = 0;
    CGAL_CHECK_EQUAL(Segment_tree(areas, lengths).body(), centre);
    check_tree(areas, lengths);
    const Index large = (centre + 1) % (arms + 1);
    areas[large] = arms;
    CGAL_CHECK_EQUAL(Segment_tree(areas, lengths).body(), large);
    check_tree(areas, lengths);
  }
}

// Of equal halves, the first one is the body, whatever was rounded.
void the_first_of_equal_halves_is_the_body()
{
  Random random(1);
  for (int i = 0; i < 1000; ++i)
  {
    const double x = random.real(0, 1) / 3, y = random.real(0, 1) / 3; // all digits used
    const Segment_tree tree({x, y, x, y}, {{{0, 1}, 1}, {{2, 3}, 1}, {{0, 2}, 1}});
    CGAL_CHECK_EQUAL(tree.body(), 0);
    CGAL_CHECK_EQUAL(tree.parent(2), 0);
    CGAL_CHECK_CLOSE(tree.area_beyond(2), x + y, 1e-15);
  }
}

// The arms of a ring have longer borders with each other than with the body.
void arms_that_touch_stick_out_of_the_body()
{
  constexpr Index arms = 8;
  const auto tree_with_borders = [](double with_body)
  {
    Lengths lengths;
    for (Index s = 1; s <= arms; ++s)
    {
      lengths[{0, s}] = with_body;
      lengths[std::minmax(s, s % arms + 1)] = 1;
    }
    return parents_of(Segment_tree(Areas(arms + 1, 1), lengths), arms + 1);
  };
  CGAL_CHECK(tree_with_borders(2) == Parents(arms + 1, 0));
  CGAL_CHECK(tree_with_borders(0.4) == Parents(arms + 1, 0));
}

// An ear touches the trunk with less than a quarter of its border with the head.
void a_short_border_with_the_body_does_not_count()
{
  const auto parent_of_ear = [](double with_trunk) {
    return Segment_tree({9, 3, 1}, {{{0, 1}, 4}, {{1, 2}, 2}, {{0, 2}, with_trunk}}).parent(2);
  };
  CGAL_CHECK_EQUAL(parent_of_ear(0), 1);
  CGAL_CHECK_EQUAL(parent_of_ear(0.45), 1);
  CGAL_CHECK_EQUAL(parent_of_ear(0.55), 0);
}

// A border of no length is one, too: two halves are connected by nothing else.
void a_border_may_have_no_length()
{
  const Segment_tree tree({1, 1, 5, 1}, {{{0, 1}, 1}, {{1, 2}, 0}, {{2, 3}, 1}});
  CGAL_CHECK(parents_of(tree, 4) == (Parents{1, 2, 2, 2}));
  check_tree({1, 1}, {{{0, 1}, 0}});
}

void random_trees(std::uint_fast32_t seed)
{
  Random random(seed);
  const std::size_t n = 1 + random.index(20);
  const std::vector<std::size_t> number = random_permutation(n, seed);
  Areas areas;
  Lengths lengths;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double large = random.index(4) == 0 ? 16 : 1;
    areas.push_back(large * double(random.index(50)));
    if (i > 0)
      lengths[std::minmax(Index(number[i]), Index(number[random.index(i)]))] = 1;
  }
  check_tree(areas, lengths);
}

// Whatever the borders, all segments stick out of neighbours, and nothing is larger than the rest.
void random_borders(std::uint_fast32_t seed)
{
  Random random(seed);
  const Index n = Index(2 + random.index(12));
  Areas areas;
  Lengths lengths;
  for (Index s = 0; s < n; ++s)
  {
    areas.push_back(1 + double(random.index(50)));
    for (std::size_t more = 1 + random.index(3); s > 0 && more-- > 0;)
      lengths[{Index(random.index(s)), s}] = random.real(0.01, 1);
  }
  const Segment_tree tree(areas, lengths);
  const double whole = std::accumulate(areas.begin(), areas.end(), 0.);
  for (Index s = 0; s < n; ++s)
    if (s != tree.body())
    {
      CGAL_CHECK_EQUAL(lengths.count(std::minmax(s, tree.parent(s))), 1u);
      CGAL_CHECK(2 * tree.area_beyond(s) <= whole * (1 + 1e-6));
    }
}

// The tree of the true parts of a shape of sticks.
Parents parents_of_parts(const std::vector<Stick>& sticks, std::size_t number_of_parts)
{
  const Test_mesh mesh = implicit_mesh(Implicit_body(sticks, 0.03), 0.12);
  Areas areas;
  for (std::size_t part = 0; part < number_of_parts; ++part)
    areas.push_back(area_of_part(mesh, part));
  Lengths lengths;
  const auto faces = faces_of_edges(mesh);
  for (const auto& [edge, left] : faces)
  {
    const std::size_t part = mesh.parts[left.front()],
                      other = mesh.parts[faces.at({edge.second, edge.first}).front()];
    if (part < other)
      lengths[{Index(part), Index(other)}] += length(mesh.points[edge.first] - mesh.points[edge.second]);
  }
  return parents_of(Segment_tree(areas, lengths), number_of_parts);
}

// Eight arms that begin side by side.
void arms_of_an_octopus()
{
  constexpr std::size_t arms = 8;
  std::vector<Stick> sticks = {{{0, 0, 0.2}, {0, 0, 1.5}, 0.6, 0.8, 0}};
  for (std::size_t i = 0; i < arms; ++i)
  {
    const double turn = 2 * CGAL_PI * double(i) / arms;
    const Point along = {std::cos(turn), std::sin(turn), 0};
    sticks.push_back({0.3 * along, 3 * along + Point{0, 0, -0.5}, 0.38, 0.15, 1 + i});
  }
  CGAL_CHECK(parents_of_parts(sticks, arms + 1) == Parents(arms + 1, 0));
}

// Trunk 0, head 1 with ears 2 and 3, arms 4 and 5, legs 6 and 7.
void parts_of_a_teddy()
{
  std::vector<Stick> sticks = {{{0, 0, 0}, {0, 0, 0.7}, 0.9, 0.8, 0}, ball({0, 0, 2}, 0.75, 1)};
  for (const double side : {-1., 1.})
  {
    const std::size_t i = side > 0;
    sticks.push_back(ball({0, side * 0.65, 2.6}, 0.3, 2 + i));
    sticks.push_back({{0, side * 0.6, 0.9}, {0.6, side * 1.6, 0.5}, 0.3, 0.3, 4 + i});
    sticks.push_back({{0.2, side * 0.5, -0.6}, {1.6, side * 0.9, -0.8}, 0.4, 0.38, 6 + i});
  }
  CGAL_CHECK(parents_of_parts(sticks, 8) == (Parents{0, 0, 1, 1, 0, 0, 0, 0}));
}

// Palm 0, fingers 1 to 4 side by side, thumb 5, forearm 6.
void fingers_of_a_hand()
{
  std::vector<Stick> sticks = {{{0, -0.4, 0}, {0, 0.4, 0}, 0.5, 0.5, 0},
                               {{0, 0.4, 0}, {0, 1.4, 0.5}, 0.25, 0.2, 5},
                               {{0, 0, 0}, {0, 0, -1.6}, 0.4, 0.4, 6}};
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double y = 0.4 * (double(i) - 1.5);
    sticks.push_back({{0, y, 0.3}, {0, 1.3 * y, 1.6}, 0.23, 0.16, 1 + i});
  }
  CGAL_CHECK(parents_of_parts(sticks, 7) == Parents(7, 0));
}

// Seat 0, legs 1 to 4, back 5 between stiles 6 and 7.
void parts_of_a_chair()
{
  std::vector<Stick> sticks;
  for (const double x : {-0.8, -0.4, 0., 0.4, 0.8})
    sticks.push_back({{x, -0.8, 0}, {x, 0.8, 0}, 0.22, 0.22, 0});
  std::size_t part = 1;
  for (const double x : {-0.8, 0.8})
    for (const double y : {-0.8, 0.8})
      sticks.push_back({{x, y, 0}, {1.1 * x, 1.1 * y, -1.8}, 0.18, 0.14, part++});
  sticks.push_back({{-0.9, -0.7, 1.6}, {-0.9, 0.7, 1.6}, 0.18, 0.18, part++});
  for (const double y : {-0.8, 0.8})
    sticks.push_back({{-0.8, y, 0}, {-0.9, y, 1.9}, 0.16, 0.14, part++});
  const Parents parents = parents_of_parts(sticks, 8);
  CGAL_CHECK(Parents(parents.begin(), parents.begin() + 5) == Parents(5, 0));
  CGAL_CHECK(parents[6] == 0 && parents[7] == 0 && (parents[5] == 6 || parents[5] == 7));
}

// Trunk 0, head 1, upper arms 2 and 3, forearms 4 and 5, hands 6 and 7, thighs 8 and 9, shanks 10 and 11.
void limbs_of_a_figure()
{
  std::vector<Stick> sticks = {{{0, 0, 0}, {0, 0, 1.1}, 0.42, 0.5, 0},
                               {{0, 0, 1.4}, {0, 0, 2.0}, 0.2, 0.4, 1}};
  for (const double side : {-1., 1.})
  {
    const std::size_t i = side > 0;
    const Point shoulder = {0, side * 0.5, 1.3}, elbow = {0, side * 1.5, 1.1},
                wrist = {0.1, side * 2.5, 1.0};
    sticks.push_back({shoulder, elbow, 0.2, 0.17, 2 + i});
    sticks.push_back({elbow, wrist, 0.17, 0.12, 4 + i});
    sticks.push_back(
      {wrist + Point{0, side * 0.2, 0}, wrist + Point{0, side * 0.5, 0}, 0.2, 0.15, 6 + i});
    const Point hip = {0, side * 0.25, -0.3}, knee = {0, side * 0.3, -1.5};
    sticks.push_back({hip, knee, 0.25, 0.2, 8 + i});
    sticks.push_back({knee, {0, side * 0.3, -2.7}, 0.2, 0.14, 10 + i});
  }
  CGAL_CHECK(parents_of_parts(sticks, 12) == (Parents{0, 0, 0, 0, 2, 3, 4, 5, 0, 0, 8, 9}));
}

// Trunk 0, three branches 1 to 3 that begin at one height, with two twigs each from 4 on.
void twigs_of_a_tree()
{
  std::vector<Stick> sticks = {{{0, 0, -2}, {0, 0, 1.2}, 0.45, 0.4, 0}};
  Parents expected = {0, 0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double turn = 2 * CGAL_PI * double(i) / 3;
    const Point along = {std::cos(turn), std::sin(turn), 0.7},
                across = {-std::sin(turn), std::cos(turn), 0.4};
    sticks.push_back({Point{0, 0, 0.8}, Point{0, 0, 0.8} + 1.8 * along, 0.26, 0.2, 1 + i});
    for (const double side : {-1., 1.})
    {
      const Point fork = Point{0, 0, 0.8} + 1.7 * along;
      sticks.push_back({fork, fork + 0.6 * along + side * 0.8 * across, 0.16, 0.1, expected.size()});
      expected.push_back(Index(1 + i));
    }
  }
  CGAL_CHECK(parents_of_parts(sticks, expected.size()) == expected);
}

int main()
{
  a_single_segment_is_the_body();
  the_body_of_a_path_holds_its_middle();
  the_centre_of_a_star_is_the_body_unless_an_arm_is_larger_than_the_rest();
  the_first_of_equal_halves_is_the_body();
  arms_that_touch_stick_out_of_the_body();
  a_short_border_with_the_body_does_not_count();
  a_border_may_have_no_length();
  for (std::uint_fast32_t seed = 0; seed < 1000; ++seed)
  {
    random_trees(seed);
    random_borders(seed);
  }
  arms_of_an_octopus();
  parts_of_a_teddy();
  fingers_of_a_hand();
  parts_of_a_chair();
  limbs_of_a_figure();
  twigs_of_a_tree();
  return check::result();
}
