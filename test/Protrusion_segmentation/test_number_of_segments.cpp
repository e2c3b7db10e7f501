// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many segments there are by what each further one gains.

#include "check.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Search/number_of_segments.h>

#include <cstddef>
#include <optional>
#include <random>
#include <vector>

using namespace CGAL::Protrusion_segmentation::internal;

std::size_t automatic_number(const std::vector<double>& gains)
{
  return number_before_largest_drop(
    [&](std::size_t number)
    { return number <= gains.size() ? std::optional<double>(gains[number - 1]) : std::nullopt; },
    Cut_options());
}

void the_largest_drop_ends_the_cuts()
{
  CGAL_CHECK_EQUAL(automatic_number({}), 1u);
  CGAL_CHECK_EQUAL(automatic_number({-0.2}), 1u);
  CGAL_CHECK_EQUAL(automatic_number({0.01, 0.5}), 1u); // not asked any further
  CGAL_CHECK_EQUAL(automatic_number({0.5}), 2u);
  CGAL_CHECK_EQUAL(automatic_number({0.5, 0.3, 0.001}), 3u);
  CGAL_CHECK_EQUAL(automatic_number({0.5, 0.3, 0.055, 0.025}), 4u);
  CGAL_CHECK_EQUAL(automatic_number({0.5, 0.3, 0.03, 0.025}), 3u);
}

// Pairs of nearly the same value, wherever they lie.
void twins_stay_together()
{
  for (double value = 0.021; value < 0.07; value += 0.001)
  {
    const std::size_t number = automatic_number({0.4, value + 0.0002, value, 0.005});
    CGAL_CHECK(number == 2 || number == 4);
    CGAL_CHECK_EQUAL(number == 4, value > 0.04);
  }
}

// A cut that gains more than one before it belongs to the same step.
void values_need_not_descend()
{
  CGAL_CHECK_EQUAL(automatic_number({0.4, 0.05, 0.3, 0.01}), 4u);
  CGAL_CHECK_EQUAL(automatic_number({0.02, 0.3}), 1u);
}

void large_gains_count_and_small_ones_do_not()
{
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i)
  {
    std::vector<double> gains;
    for (double value = 0.3; gains.size() < 12; value *= 0.4 + 0.6 * random() / 4294967296.)
      gains.push_back(value);
    std::size_t surely = 1, possibly = 1;
    for (double gain : gains)
    {
      surely += gain >= 0.06;
      possibly += gain > 0.02;
    }
    const std::size_t number = automatic_number(gains);
    CGAL_CHECK(surely <= number && number <= possibly);
  }
}

// Cuts of which the given shares of the value are distinct and not.
Cut_set set_of_cuts(double of_distinct, double of_others)
{
  Cut_set set;
  set.cuts.push_back({0, 1, 2, of_others, 0.5, false});
  set.cuts.push_back({1, 3, 4, of_distinct, 0.5, true});
  set.value = of_distinct + of_others;
  return set;
}

// Some cuts of a rough tube are distinct by chance.
void without_distinct_cuts_there_is_one_segment()
{
  const auto number = [](double of_distinct, double of_others)
  {
    const std::vector<double> gains = {of_others, of_distinct};
    return automatic_number_of_segments(
      [&](std::size_t n) { return n <= gains.size() ? std::optional<double>(gains[n - 1]) : std::nullopt; },
      [&](std::size_t) { return set_of_cuts(of_distinct, of_others); }, Cut_options());
  };
  CGAL_CHECK_EQUAL(number(0.24, 0.76), 1u);
  CGAL_CHECK_EQUAL(number(0.26, 0.74), 3u);
  CGAL_CHECK_EQUAL(number(0.5, 0.5), 3u);
}

int main()
{
  without_distinct_cuts_there_is_one_segment();
  the_largest_drop_ends_the_cuts();
  twins_stay_together();
  values_need_not_descend();
  large_gains_count_and_small_ones_do_not();
  return check::result();
}
