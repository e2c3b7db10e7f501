// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a cut is worth by the areas of its sides and by what speaks for it.

#include "check.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut.h>

#include <cmath>

using namespace CGAL::Protrusion_segmentation::internal;

constexpr double precision = 1e-12;

struct Given_odds : Cut_policy
{
  double log_odds(const Cut_clues&) const override { return given; }

  double given = 0;
};

// of a cut of a segment, with the given logarithm of the odds
double value(double log_odds, double area, double segment_area)
{
  Given_odds policy;
  policy.given = log_odds;
  Cut cut;
  cut.separation = separation(area, segment_area);
  value_by_clues(policy, cut);
  CHECK_EQUAL(cut.probability, probability_of_border(log_odds));
  return cut.value;
}

void halves_are_separated_most()
{
  CHECK_CLOSE(separation(0.5, 1), std::pow(2, -0.8), precision);
  for (const double area : {0.001, 0.01, 0.1, 0.3, 0.49})
  {
    CHECK(separation(area, 1) < separation(0.5, 1));
    CHECK_CLOSE(separation(area, 1), separation(1 - area, 1), precision);
    CHECK_CLOSE(separation(area / 8, 0.125), separation(area, 1) / 8, precision); // shares count, and the segment's size
  }
}

// Two arms of a tenth are worth more one by one than a cut around both that is as sure.
void arms_are_cut_off_one_by_one()
{
  CHECK(separation(0.1, 1) + separation(0.1, 0.9) > separation(0.2, 1) + separation(0.1, 0.2));
}

void what_speaks_for_a_cut_counts_more_than_in_proportion()
{
  CHECK_EQUAL(value(0, 0.2, 0.6), 0);
  for (const double log_odds : {0.5, 1., 2., 5.})
  {
    const double certainty = std::tanh(log_odds / 2);
    CHECK_CLOSE(value(log_odds, 0.2, 0.6), std::pow(certainty, 1.5) * separation(0.2, 0.6), precision);
    CHECK_CLOSE(value(-log_odds, 0.2, 0.6), -value(log_odds, 0.2, 0.6), precision);
  }
  CHECK_CLOSE(value(100, 0.5, 1), separation(0.5, 1), precision);
}

int main()
{
  halves_are_separated_most();
  arms_are_cut_off_one_by_one();
  what_speaks_for_a_cut_counts_more_than_in_proportion();
  return check::result();
}
