// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which segment is the body, and what lies beyond each border: against brute force on trees.

#include "check.h"
#include "test_meshes_transformations.h"

#include <CGAL/Protrusion_segmentation/internal/Segments/Segment_tree.h>

#include <set>

using namespace test_meshes;
using CGAL::Protrusion_segmentation::internal::Segment_tree;
using Index = Segment_tree::Index;
using Areas = std::vector<double>;
using Borders = std::vector<Segment_tree::Border>;

// The segments on the side of `from` when a border is closed.
std::set<Index> side_of(Index from, std::size_t closed, const Borders& borders)
{
  std::set<Index> side = {from};
  for (bool grows = true; grows;)
  {
    grows = false;
    for (std::size_t b = 0; b < borders.size(); ++b)
      if (b != closed && side.count(borders[b].first) != side.count(borders[b].second))
      {
        side.insert(borders[b].first);
        side.insert(borders[b].second);
        grows = true;
      }
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

// Areas whose sums are exact, so that halves are.
void check_tree(const Areas& areas, const Borders& borders)
{
  const Segment_tree tree(areas, borders);
  const double whole = std::accumulate(areas.begin(), areas.end(), 0.);
  std::set<std::size_t> used;
  CHECK_EQUAL(tree.parent(tree.body()), tree.body());
  CHECK_EQUAL(tree.area_beyond(tree.body()), whole);
  for (Index s = 0; s < areas.size(); ++s)
  {
    if (s == tree.body())
      continue;
    const std::size_t border = tree.border_to_parent(s);
    used.insert(border);
    CHECK(borders[border] == std::make_pair(s, tree.parent(s)) ||
          borders[border] == std::make_pair(tree.parent(s), s));
    const std::set<Index> beyond = side_of(s, border, borders);
    CHECK(beyond.count(tree.body()) == 0 && beyond.count(tree.parent(s)) == 0);
    CHECK_EQUAL(tree.area_beyond(s), sum_over(beyond, areas));
    CHECK(2 * tree.area_beyond(s) <= whole);
  }
  CHECK_EQUAL(used.size(), borders.size());
}

void a_single_segment_is_the_body()
{
  check_tree({3}, {});
  CHECK_EQUAL(Segment_tree({3}, {}).body(), 0);
}

void the_body_of_a_path_holds_its_middle()
{
  const Borders path = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  CHECK_EQUAL(Segment_tree({1, 1, 1, 1, 1}, path).body(), 2);
  CHECK_EQUAL(Segment_tree({1, 1, 1, 1, 7}, path).body(), 4);
  CHECK_EQUAL(Segment_tree({1, 1, 1, 4, 2}, path).body(), 3);
  for (const Areas& areas : {Areas{1, 1, 1, 1, 1}, {1, 1, 1, 1, 7}, {1, 1, 1, 4, 2}, {7, 1, 0, 1, 1}})
    check_tree(areas, path);
}

// Whatever the number of the centre, and the direction in which borders are written.
void the_centre_of_a_star_is_the_body_unless_an_arm_is_larger_than_the_rest()
{
  constexpr Index arms = 6;
  for (Index centre = 0; centre <= arms; ++centre)
  {
    Borders borders;
    for (Index s = 0; s <= arms; ++s)
      if (s != centre)
        borders.push_back(s % 2 == 0 ? Segment_tree::Border(s, centre) : Segment_tree::Border(centre, s));
    Areas areas(arms + 1, 1);
    areas[centre] = 0;
    CHECK_EQUAL(Segment_tree(areas, borders).body(), centre);
    check_tree(areas, borders);
    const Index large = (centre + 1) % (arms + 1);
    areas[large] = arms;
    CHECK_EQUAL(Segment_tree(areas, borders).body(), large);
    check_tree(areas, borders);
  }
}

// Half is not more than half: both are right, but nothing goes back and forth.
void halves_are_protrusions()
{
  check_tree({1, 1}, {{0, 1}});
  check_tree({1, 2, 2, 1}, {{0, 1}, {1, 2}, {2, 3}});
  check_tree({0, 0, 0}, {{0, 1}, {1, 2}});
}

// Two halves of two segments each, the outer borders made before the middle one: with rounded sums, either half may
// have more than half of the sum seen from the other one. That must not go on for ever.
void rounded_halves_have_a_body()
{
  Random random(1);
  for (int i = 0; i < 1000; ++i)
  {
    const double x = random.real(0, 1) / 3, y = random.real(0, 1) / 3; // all digits used
    const Segment_tree tree({x, y, x, y}, {{0, 1}, {2, 3}, {0, 2}});
    CHECK(tree.body() == 0 || tree.body() == 2);
    const Index other = 2 - tree.body();
    CHECK_EQUAL(tree.parent(other), tree.body());
    CHECK_CLOSE(tree.area_beyond(other), x + y, 1e-15);
  }
}

void random_trees(std::uint_fast32_t seed)
{
  Random random(seed);
  const std::size_t n = 1 + random.index(20);
  const std::vector<std::size_t> number = random_permutation(n, seed);
  Areas areas;
  Borders borders;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double large = random.index(4) == 0 ? 16 : 1;
    areas.push_back(large * double(random.index(50)));
    if (i > 0)
      borders.emplace_back(Index(number[i]), Index(number[random.index(i)]));
  }
  for (std::size_t i = borders.size(); i > 1; --i)
    std::swap(borders[i - 1], borders[random.index(i)]);
  check_tree(areas, borders);
}

int main()
{
  a_single_segment_is_the_body();
  the_body_of_a_path_holds_its_middle();
  the_centre_of_a_star_is_the_body_unless_an_arm_is_larger_than_the_rest();
  halves_are_protrusions();
  rounded_halves_have_a_body();
  for (std::uint_fast32_t seed = 0; seed < 1000; ++seed)
    random_trees(seed);
  return check::result();
}
