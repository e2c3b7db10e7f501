// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts that are alike are evidence for each other: equal arms come off together or not at all.

#include "check.h"
#include "distinct_cuts.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/like_parts.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

using namespace CGAL::Protrusion_segmentation;
using namespace test_meshes;
using internal::Cut;
using internal::Cut_options;
using internal::Nodes;

std::vector<double> like_parts(std::vector<Cut> cuts)
{
  internal::find_like_parts(Cut_options(), cuts);
  std::vector<double> result;
  for (const Cut& cut : cuts)
    result.push_back(cut.like_part);
  return result;
}

void equal_parts_say_the_full_weight()
{
  const internal::Size_of_part size = {-2, -1, -0.5}, near = {-2.1, -1, -0.5}, other = {-2.2, -1, -0.5};
  const double full = Cut_options().weights.like_part;
  CGAL_CHECK((like_parts({cut_of({1, 2}, 0, size), cut_of({3, 5}, -0.5, size)}) == std::vector{full, full}));
  CGAL_CHECK((like_parts({cut_of({1, 2}, 0, size), cut_of({3, 5}, 0, other)}) == std::vector{0., 0.}));
  const std::vector<double> of_near = like_parts({cut_of({1, 2}, 0, size), cut_of({3, 5}, 0, near)});
  CGAL_CHECK_CLOSE(of_near[0], full * std::exp(-0.01 / (2 * 0.15 * 0.15)), 1e-12);
  CGAL_CHECK_EQUAL(of_near[0], of_near[1]);
}

void what_overlaps_or_is_no_part_says_nothing()
{
  const internal::Size_of_part size = {-2, -1, -0.5};
  CGAL_CHECK((like_parts({}).empty()));
  CGAL_CHECK((like_parts({cut_of({1, 2}, 0, size)}) == std::vector{0.}));
  CGAL_CHECK((like_parts({cut_of({1, 2, 9}, 0, size), cut_of({3, 5, 9}, 0, size)}) == std::vector{0., 0.}));
  CGAL_CHECK((like_parts({cut_of({1, 2}, 0, size), cut_of({3, 5}, -2.1, size)}) == std::vector{0., 0.}));
  Cut anywhere = cut_of({3, 5}, 0, size);
  anywhere.clues.widening = 0;
  CGAL_CHECK((like_parts({cut_of({1, 2}, 0, size), anywhere}) == std::vector{0., 0.}));
}

void beside_sure_parts_only_these_are_evidence()
{
  const internal::Size_of_part size = {-2, -1, -0.5}, other = {-1, -1, -0.5};
  const double full = Cut_options().weights.like_part, sure = Cut_options().sure_log_odds;
  CGAL_CHECK((like_parts({cut_of({1}, sure, size), cut_of({2}, 0, size), cut_of({3}, 0, other), cut_of({4}, 0, other)}) ==
         std::vector{0., full, 0., 0.}));
  CGAL_CHECK((like_parts({cut_of({1}, sure, size), cut_of({2}, sure, size)}) == std::vector{full, full}));
}

// A plate in the form of a star whose notches are at a share of the radius of its tips. Part 0 is the body; it has no walls.
Test_mesh wide_star(std::size_t arms, double share, double height)
{
  Test_mesh mesh;
  Face below, above; // of every arm the notch before it, and its tip
  for (std::size_t i = 0; i < 2 * arms; ++i)
  {
    const double angle = pi * double(i) / double(arms), r = i % 2 == 0 ? share : 1;
    below.push_back(mesh.add_point({r * std::cos(angle), r * std::sin(angle), 0}));
    above.push_back(mesh.add_point({r * std::cos(angle), r * std::sin(angle), height}));
  }
  Face body_below, body_above;
  for (std::size_t i = 0; i < 2 * arms; i += 2)
  {
    const std::size_t next = (i + 2) % (2 * arms), arm = i / 2 + 1;
    mesh.add_face({above[i], above[i + 1], above[next]}, arm);
    mesh.add_face({below[next], below[i + 1], below[i]}, arm);
    mesh.add_face({below[i], below[i + 1], above[i + 1], above[i]}, arm);
    mesh.add_face({below[i + 1], below[next], above[next], above[i + 1]}, arm);
    body_above.push_back(above[i]);
    body_below.insert(body_below.begin(), below[i]);
  }
  mesh.add_face(body_above, 0);
  mesh.add_face(body_below, 0);
  return mesh;
}

// Every arm is a segment, and the body is one with the last arm: without that its two faces would not be connected.
void wide_arms_come_off_together(std::size_t arms)
{
  const Test_mesh star = wide_star(arms, 0.4, 0.3);
  for (const Segmentation& found : {automatic_segmentation(star), given_segmentation(star, arms)})
  {
    CGAL_CHECK_EQUAL(found.number, arms);
    std::vector<std::set<std::size_t>> labels(arms + 1);
    for (std::size_t f = 0; f < star.parts.size(); ++f)
      labels[star.parts[f]].insert(found.labels[f]);
    std::set<std::size_t> of_arms;
    for (std::size_t arm = 1; arm <= arms; ++arm)
    {
      CGAL_CHECK_EQUAL(labels[arm].size(), 1u);
      of_arms.insert(labels[arm].begin(), labels[arm].end());
    }
    CGAL_CHECK_EQUAL(of_arms.size(), arms);
  }
}

// These gears lost one to three teeth: on a thin ring the last ones widen less beside earlier borders than the first.
void the_last_teeth_are_as_sure_as_the_first()
{
  for (const Test_mesh& mesh : {gear(9, 0.525, 1.2, 0.3), gear(9, 0.525, 1.3, 0.2), gear(13, 0.575, 1.3, 0.2),
                                gear(11, 0.625, 1.3, 0.3)})
    CGAL_CHECK(as_partition(automatic_segmentation(mesh).labels) == as_partition(mesh.parts));
}

int main()
{
  equal_parts_say_the_full_weight();
  what_overlaps_or_is_no_part_says_nothing();
  beside_sure_parts_only_these_are_evidence();
  for (std::size_t arms = 4; arms <= 9; ++arms)
    wide_arms_come_off_together(arms);
  the_last_teeth_are_as_sure_as_the_first();
  return check::result();
}
