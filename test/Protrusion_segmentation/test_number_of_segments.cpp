// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many segments there are by what each further one gains.

#include "check.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Beam/number_of_segments.h>

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

int main()
{
  the_largest_drop_ends_the_cuts();
  twins_stay_together();
  values_need_not_descend();
  large_gains_count_and_small_ones_do_not();
  return check::result();
}
