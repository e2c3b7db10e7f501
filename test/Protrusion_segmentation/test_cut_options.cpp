// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What clues say together, and the costs of cuts.

#include "check.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_options.h>

#include <cmath>

using namespace CGAL::Protrusion_segmentation::internal;

// Flat pieces count for less, and so do cuts without a shoulder, such as those through a trunk; both within limits.
void clues_have_limits()
{
  const auto log_odds = [](double shoulder, double flatness, double length)
  {
    Cut_clues clues = {};
    clues.larger_shoulder = shoulder;
    clues.flatness = flatness;
    clues.relative_length = length;
    return Cut_options().weights(clues);
  };
  const double usual = log_odds(0.2, 0.5, 0.5);
  CGAL_CHECK(log_odds(0.3, 0.5, 0.5) > usual && log_odds(0.1, 0.5, 0.5) < usual);
  CGAL_CHECK_EQUAL(log_odds(0.9, 0.5, 0.5), log_odds(0.3, 0.5, 0.5));
  CGAL_CHECK_EQUAL(log_odds(-1, 0.5, 0.5), log_odds(0.1, 0.5, 0.5));
  CGAL_CHECK_EQUAL(log_odds(0.2, 0.1, 0.5), usual);
  double last = log_odds(0.2, 0.6, 0.5);
  CGAL_CHECK_EQUAL(last, usual);
  for (const double flatness : {0.7, 0.8, 0.9, 1.})
  {
    CGAL_CHECK(log_odds(0.2, flatness, 0.5) < last);
    last = log_odds(0.2, flatness, 0.5);
  }
  CGAL_CHECK(log_odds(0.2, 0.5, 1) < usual && log_odds(0.2, 0.5, 0) > usual);
  CGAL_CHECK_EQUAL(log_odds(0.2, 0.5, -2), log_odds(0.2, 0.5, -0.3));
}

// Seams are cheap, ridges less so, and nothing is cheaper than the least cost.
void seams_are_cheap()
{
  const Cut_options options;
  CGAL_CHECK_CLOSE(options.cost(3, 0), 3, 1e-12);
  CGAL_CHECK(options.cost(1, 1) < options.cost(1, 0) && options.cost(1, 10) < options.cost(1, 1));
  CGAL_CHECK(options.cost(1, -10) < 1 && options.cost(1, -10) > options.cost(1, 10));
  CGAL_CHECK_CLOSE(options.cost(1, 1000), options.least_cost, 1e-12);
}

// By the area to the power of 3/4.
void relative_costs_have_known_values()
{
  CGAL_CHECK_CLOSE(cost_for_area(2, 1), 2, 1e-12);
  CGAL_CHECK_CLOSE(cost_for_area(2, 1. / 16), 16, 1e-12);
  CGAL_CHECK(is_large_enough(0.0025, 1) && !is_large_enough(0.0024, 1));
  CGAL_CHECK(is_large_enough(0.9974, 1) && !is_large_enough(0.9976, 1));
}

// Even log odds are near one half, and probabilities rise with them.
void probabilities_rise()
{
  CGAL_CHECK_EQUAL(logistic(0), 0.5);
  CGAL_CHECK_CLOSE(logistic(std::log(3.)), 0.75, 1e-12);
  for (double log_odds = -20; log_odds < 20; log_odds += 0.5)
  {
    CGAL_CHECK(probability_of_border(log_odds) < probability_of_border(log_odds + 0.5));
    CGAL_CHECK(probability_of_border(log_odds) > 0 && probability_of_border(log_odds) < 1);
  }
}

int main()
{
  clues_have_limits();
  seams_are_cheap();
  relative_costs_have_known_values();
  probabilities_rise();
  return check::result();
}
