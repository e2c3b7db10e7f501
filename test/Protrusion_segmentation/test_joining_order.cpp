// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In which order segments are given to their parents, against brute force.

#include "check.h"
#include "test_meshes_transformations.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Result/Joining_order.h>

using namespace test_meshes;
using CGAL::Protrusion_segmentation::internal::Joining_order;
using CGAL::Protrusion_segmentation::internal::Segment_tree;
using Index = Segment_tree::Index;
using Labels = std::vector<std::size_t>; // of points of the same area

// Three arms of a body, in the order of their numbers.
Segment_tree star_tree()
{
  return Segment_tree({3, 1, 1, 1}, {{{0, 1}, 1}, {{0, 2}, 1}, {{0, 3}, 1}});
}

void without_others_the_order_stays()
{
  const Segment_tree tree = star_tree();
  Joining_order joining(tree, {0, 1, 1, 1}, {0, 2, 1, 3});
  while (joining.number_left() > 1)
    joining.join_last();
  CGAL_CHECK(joining() == (std::vector<Index>{0, 2, 1, 3}));
}

// Of arms 2 and 3, which are worth the same, the last one of the order.
void least_valuable_segments_are_joined_first()
{
  const Segment_tree tree = star_tree();
  Joining_order joining(tree, {0, 3, 2, 2}, {0, 3, 1, 2});
  CGAL_CHECK_EQUAL(joining.value_without_least_valuable(), 5);
  joining.join_least_valuable();
  CGAL_CHECK_EQUAL(joining.value_without_least_valuable(), 3);
  joining.join_least_valuable();
  CGAL_CHECK_EQUAL(joining.value_without_least_valuable(), 0);
  CGAL_CHECK(joining() == (std::vector<Index>{0, 1, 3, 2}));
}

// The others join arm 1 first, and then arm 3.
void the_order_is_that_of_others()
{
  const Segment_tree tree = star_tree();
  Joining_order joining(tree, {0, 1, 1, 1}, {0, 1, 2, 3});
  joining.join_for({{3, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  joining.join_for({{3, 0}, {1, 0}, {0, 1}, {1, 0}});
  CGAL_CHECK_EQUAL(joining.number_left(), 2u);
  CGAL_CHECK(joining() == (std::vector<Index>{0, 2, 3, 1}));
}

// The share of pairs that are together in one of the two only.
double rand_index_error(const Labels& a, const Labels& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      sum += (a[i] == a[j]) != (b[i] == b[j]);
  return sum;
}

// With all segments but the first `number` of the order joined.
Labels joined(const Labels& labels,
              const std::vector<Index>& order,
              std::size_t number,
              const Segment_tree& tree)
{
  Labels result = labels;
  for (std::size_t& label : result)
    while (std::find(order.begin(), order.begin() + std::ptrdiff_t(number), label) ==
           order.begin() + std::ptrdiff_t(number))
      label = tree.parent(Index(label));
  return result;
}

void each_step_has_the_least_error(std::uint_fast32_t seed)
{
  Random random(seed);
  const std::size_t n = 3 + random.index(6), points = 40;
  Segment_tree::Lengths lengths;
  for (Index s = 1; s < n; ++s)
    lengths[{Index(random.index(s)), s}] = 1;
  Labels labels;
  for (std::size_t i = 0; i < points; ++i)
    labels.push_back(i < n ? i : random.index(n));
  std::vector<double> areas(n, 0);
  for (const std::size_t label : labels)
    ++areas[label];
  const Segment_tree tree(areas, lengths);
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), Index(0));
  std::swap(order[0], order[tree.body()]);
  Joining_order joining(tree, std::vector<double>(n, 1), order);
  while (joining.number_left() > 2)
  {
    const std::size_t left = joining.number_left();
    Labels other;
    for (std::size_t i = 0; i < points; ++i)
      other.push_back(i < left - 1 ? i : random.index(left - 1));
    Joining_order::Overlaps overlaps(n, std::vector<double>(left - 1, 0));
    for (std::size_t i = 0; i < points; ++i)
      ++overlaps[labels[i]][other[i]];
    const std::vector<Index> before = joining();
    double least = points * points;
    for (std::size_t place = 1; place < left; ++place)
    {
      std::vector<Index> tried = before;
      std::rotate(tried.begin() + std::ptrdiff_t(place), tried.begin() + std::ptrdiff_t(place) + 1,
                  tried.begin() + std::ptrdiff_t(left));
      least = (std::min)(least, rand_index_error(joined(labels, tried, left - 1, tree), other));
    }
    joining.join_for(overlaps);
    CGAL_CHECK_EQUAL(rand_index_error(joined(labels, joining(), left - 1, tree), other), least);
  }
  std::vector<Index> all = joining();
  CGAL_CHECK_EQUAL(all.front(), tree.body());
  std::sort(all.begin(), all.end());
  std::sort(order.begin(), order.end());
  CGAL_CHECK(all == order);
}

int main()
{
  without_others_the_order_stays();
  least_valuable_segments_are_joined_first();
  the_order_is_that_of_others();
  for (std::uint_fast32_t seed = 0; seed < 500; ++seed)
    each_step_has_the_least_error(seed);
  return check::result();
}
