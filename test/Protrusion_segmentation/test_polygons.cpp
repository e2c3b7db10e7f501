// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons in a row are what a vector of vectors is.

#include "check.h"

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygons.h>

#include <cstddef>
#include <random>
#include <vector>

using CGAL::Protrusion_segmentation::internal::Polygons;

void check_polygons(const Polygons& found, const std::vector<std::vector<std::size_t>>& expected)
{
  CGAL_CHECK_EQUAL(found.size(), expected.size());
  CGAL_CHECK_EQUAL(found.empty(), expected.empty());
  std::vector<std::vector<std::size_t>> visited;
  for (const Polygons::Corners& corners : found)
    visited.emplace_back(corners.begin(), corners.end());
  CGAL_CHECK(visited == expected);
  std::size_t corner = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    CGAL_CHECK_EQUAL(found.first_corner(i), corner);
    CGAL_CHECK_EQUAL(std::size_t(found[i].size()), expected[i].size());
    for (const std::size_t point : expected[i])
      CGAL_CHECK_EQUAL(found.corner(corner++), point);
  }
  CGAL_CHECK_EQUAL(found.number_of_corners(), corner);
  CGAL_CHECK_EQUAL(found.corners().size(), corner);
}

// Of 0 to 6 corners.
void random_polygons(std::uint_fast32_t seed)
{
  std::mt19937 random(seed);
  Polygons found;
  found.reserve(random() % 100, random() % 500);
  std::vector<std::vector<std::size_t>> expected(random() % 100);
  for (auto& polygon : expected)
  {
    for (std::size_t left = random() % 7; left > 0; --left)
      polygon.push_back(random());
    found.add(polygon);
  }
  check_polygons(found, expected);
}

int main()
{
  check_polygons(Polygons(), {});
  Polygons listed;
  listed.add({0, 4294967295, 2});
  listed.add({});
  check_polygons(listed, {{0, 4294967295, 2}, {}});
  for (std::uint_fast32_t seed = 0; seed < 50; ++seed)
    random_polygons(seed);
  return check::result();
}
