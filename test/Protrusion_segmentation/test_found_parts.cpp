// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts that were found in a larger segment are tried again in a smaller one if they are like one that has been cut off.

#include "check.h"
#include "distinct_cuts.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/Found_parts.h>

#include <cstddef>
#include <vector>

using namespace CGAL::Protrusion_segmentation;
using namespace test_meshes;
using internal::Cut;
using internal::Cut_set;
using internal::Cut_weights;
using internal::Found_parts;
using internal::Nodes;

const internal::Size_of_part tooth = {-3, -1, -0.5}, other = {-2, -1, -0.5};

Cut_set set_that_cuts_off(internal::Size_of_part size)
{
  Cut_set set;
  set.cuts.emplace_back();
  set.cuts.back().size = size;
  return set;
}

void parts_like_one_cut_off_are_found_again()
{
  const Cut_weights weights;
  Found_parts parts(weights);
  parts.add({cut_of({1, 2}, 0, tooth), cut_of({3, 4}, 0, tooth), cut_of({5, 6}, 0, other)});
  parts.add({cut_of({1, 2}, 0, tooth)}); // once
  const internal::Segment segment{{1, 2, 3, 5, 6}, 1};
  const std::vector<Nodes> none;
  CGAL_CHECK(parts.like_those_of(set_that_cuts_off(tooth), segment, {}) == std::vector<Nodes>(1, {1, 2}));
  CGAL_CHECK(parts.like_those_of(set_that_cuts_off(other), segment, {}) == std::vector<Nodes>(1, {5, 6}));
  CGAL_CHECK(parts.like_those_of({}, segment, {}) == none);
}

void what_the_segment_has_itself_is_not_found_again()
{
  const Cut_weights weights;
  Found_parts parts(weights);
  parts.add({cut_of({1, 2}, 0, tooth)});
  const internal::Segment segment{{1, 2, 3}, 1};
  const Cut_set set = set_that_cuts_off(tooth);
  CGAL_CHECK(parts.like_those_of(set, segment, {cut_of({2, 3}, 0, tooth)}).empty());
  CGAL_CHECK_EQUAL(parts.like_those_of(set, segment, {cut_of({3}, 0, tooth)}).size(), 1u);
  CGAL_CHECK_EQUAL(parts.like_those_of(set, segment, {cut_of({2, 3}, 0, other)}).size(), 1u);
}

void what_is_no_part_is_not_kept()
{
  const Cut_weights weights;
  Found_parts parts(weights);
  Cut anywhere = cut_of({1}, 0, tooth);
  anywhere.clues.widening = 0;
  parts.add({anywhere, cut_of({2}, -2.1, tooth)});
  CGAL_CHECK(parts.like_those_of(set_that_cuts_off(tooth), {{1, 2, 3}, 1}, {}).empty());
}

// Three of these gears lost a tooth.
void all_teeth_of_thin_rings_are_segments()
{
  for (double bore : {0.6, 0.65})
    for (double reach : {1.2, 1.3})
      for (double height : {0.2, 0.3})
      {
        const Test_mesh mesh = gear(14, bore, reach, height);
        for (const Segmentation& found : {automatic_segmentation(mesh), given_segmentation(mesh, 15)})
          CGAL_CHECK(as_partition(found.labels) == as_partition(mesh.parts));
      }
}

int main()
{
  parts_like_one_cut_off_are_found_again();
  what_the_segment_has_itself_is_not_found_again();
  what_is_no_part_is_not_kept();
  all_teeth_of_thin_rings_are_segments();
  return check::result();
}
