// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the cuts of a surface run in the end, and what sticks out of what by that.

#include "check.h"
#include "test_meshes_transformations.h"

#include <CGAL/Protrusion_segmentation/internal/Segments/Borders_of_cuts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

using CGAL::Protrusion_segmentation::internal::Borders_of_cuts;
using CGAL::Protrusion_segmentation::internal::Segment_tree;
using CGAL::Protrusion_segmentation::internal::Sides_of_cut;
using test_meshes::Random;

using Index = Borders_of_cuts::Index;
using Border = Borders_of_cuts::Border;
using Borders = std::vector<Border>;
using Cuts = std::vector<Sides_of_cut>;

Borders borders_of(const Borders_of_cuts::Lengths& lengths, const Cuts& cuts)
{
  return Borders_of_cuts(lengths, cuts)();
}

// A trunk 0 with a head 1 and two arms 2 and 3; every cut runs where it was made.
void cuts_stay_at_their_borders()
{
  const Borders_of_cuts::Lengths lengths = {{{0, 1}, 3}, {{0, 2}, 2}, {{0, 3}, 2}};
  const Cuts cuts = {{{1}, {0, 2, 3}}, {{3}, {0, 2}}, {{2}, {0}}};
  CHECK(borders_of(lengths, cuts) == (Borders{{0, 1}, {0, 3}, {0, 2}}));
}

// The head and an arm were cut off together, then the arm from the head, which it still touches.
void an_arm_sticks_out_of_what_it_has_its_longest_border_with()
{
  const Cuts cuts = {{{1, 2}, {0}}, {{2}, {1}}};
  const Borders_of_cuts::Lengths with_head = {{{0, 1}, 3}, {{0, 2}, 1}, {{1, 2}, 2}};
  CHECK(borders_of(with_head, cuts) == (Borders{{0, 1}, {1, 2}}));
  const Borders_of_cuts::Lengths with_trunk = {{{0, 1}, 3}, {{0, 2}, 2}, {{1, 2}, 1}};
  CHECK(borders_of(with_trunk, cuts) == (Borders{{0, 1}, {0, 2}}));
  CHECK_EQUAL(Segment_tree({5, 2, 1}, borders_of(with_trunk, cuts)).parent(2), 0);
}

// Where two borders are equally long, the cut stays at its own.
void equally_long_borders_change_nothing()
{
  const Cuts cuts = {{{1, 2}, {0}}, {{2}, {1}}};
  CHECK(borders_of({{{0, 1}, 3}, {{0, 2}, 2}, {{1, 2}, 2}}, cuts) == (Borders{{0, 1}, {1, 2}}));
}

// The sides of the last cut touch no more.
void a_cut_without_a_border_gets_one_that_is_left()
{
  const Cuts cuts = {{{1, 2}, {0}}, {{2}, {1}}};
  CHECK(borders_of({{{0, 1}, 3}, {{0, 2}, 1}}, cuts) == (Borders{{0, 1}, {0, 2}}));
}

void one_segment_has_no_border()
{
  CHECK(borders_of({}, {}).empty());
}

double longest_total(const Borders_of_cuts::Lengths& lengths, std::size_t n)
{
  std::set<Index> reached = {0};
  double total = 0;
  while (reached.size() < n)
  {
    const auto length_if_new = [&](const auto& border)
    { return reached.count(border.first.first) == reached.count(border.first.second) ? 0 : border.second; };
    const auto longest = std::max_element(lengths.begin(), lengths.end(), [&](const auto& a, const auto& b)
                                          { return length_if_new(a) < length_if_new(b); });
    total += longest->second;
    reached.insert({longest->first.first, longest->first.second});
  }
  return total;
}

// Segments 0 to n - 1, made by cutting random ones again and again, with random neighbours.
void random_cuts(std::uint_fast32_t seed)
{
  Random random(seed);
  const std::size_t n = 2 + random.index(12);
  Borders_of_cuts::Lengths lengths;
  const auto add_border = [&](std::size_t s, std::size_t t)
  { lengths[{static_cast<Index>((std::min)(s, t)), static_cast<Index>((std::max)(s, t))}] = double(1 + random.index(9)); };
  for (std::size_t s = 1; s < n; ++s)
    add_border(s, random.index(s));
  for (std::size_t more = random.index(2 * n); more-- > 0;)
    if (const std::size_t s = random.index(n), t = random.index(n); s != t)
      add_border(s, t);

  std::vector<std::vector<Index>> pieces(1);
  for (Index s = 0; s < n; ++s)
    pieces.front().push_back(s);
  Cuts cuts;
  while (pieces.size() < n)
  {
    std::vector<Index>& piece = pieces[random.index(pieces.size())];
    if (piece.size() == 1)
      continue;
    const auto middle = piece.begin() + static_cast<std::ptrdiff_t>(1 + random.index(piece.size() - 1));
    cuts.push_back({{piece.begin(), middle}, {middle, piece.end()}});
    piece = cuts.back().inner;
    pieces.push_back(cuts.back().outer);
  }

  const Borders found = borders_of(lengths, cuts);
  double total = 0;
  for (const Border& border : found)
    total += lengths.at(border); // throws if there is no such border
  CHECK_EQUAL(total, longest_total(lengths, n));
  CHECK_EQUAL(std::set<Border>(found.begin(), found.end()).size(), n - 1);
  Segment_tree(std::vector<double>(n, 1), found); // all segments hang together, or its assertion fails
}

int main()
{
  cuts_stay_at_their_borders();
  an_arm_sticks_out_of_what_it_has_its_longest_border_with();
  equally_long_borders_change_nothing();
  a_cut_without_a_border_gets_one_that_is_left();
  one_segment_has_no_border();
  for (std::uint_fast32_t seed = 0; seed < 2000; ++seed)
    random_cuts(seed);
  return check::result();
}
