// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Area and centroid of polygons, worked out by hand.

#include "check.h"

#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using CGAL::Protrusion_segmentation::internal::measure_polygon;
using CGAL::Protrusion_segmentation::internal::polygon_area_vector;

constexpr double exact = 1e-12;

double distance(const Point& a, const Point& b)
{
  return std::sqrt(CGAL::squared_distance(a, b));
}

void check_measures(const std::vector<Point>& corners, double area, const Point& centroid)
{
  const auto measures = measure_polygon(corners);
  CGAL_CHECK_CLOSE(measures.area, area, exact);
  CGAL_CHECK_CLOSE(distance(measures.centroid, centroid), 0, exact);
}

void test_area_vector()
{
  const std::vector<Point> square = {Point(1, 1, 3), Point(3, 1, 3), Point(3, 3, 3), Point(1, 3, 3)};
  CGAL_CHECK(polygon_area_vector(square) == Vector(0, 0, 4));
  CGAL_CHECK(polygon_area_vector(std::vector<Point>(square.rbegin(), square.rend())) == Vector(0, 0, -4));
}

void test_triangle()
{
  check_measures({Point(0, 0, 1), Point(3, 0, 1), Point(0, 6, 1)}, 9, Point(1, 2, 1));
}

// Unit squares at (0,0), (1,0) and (0,1): one corner is reflex, and any corner may be the first.
void test_polygon_that_is_not_convex()
{
  std::vector<Point> corners = {Point(0, 1, 5), Point(0, 0, 5), Point(2, 0, 5), Point(2, 1, 5),
                                Point(1, 1, 5), Point(1, 2, 5), Point(0, 2, 5)};
  for (std::size_t first = 0; first < corners.size(); ++first)
  {
    check_measures(corners, 3, Point(5 / 6., 5 / 6., 5));
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
}

void test_no_area_gives_the_mean_of_the_corners()
{
  check_measures({Point(0, 0, 0), Point(1, 0, 0), Point(5, 0, 0)}, 0, Point(2, 0, 0));
  check_measures({Point(0, 0, 0), Point(1, 0, 0), Point(5, 0, 0), Point(2, 0, 0)}, 0, Point(2, 0, 0));
  check_measures({Point(1, 2, 3), Point(1, 2, 3), Point(1, 2, 3), Point(1, 2, 3)}, 0, Point(1, 2, 3));
  check_measures({Point(1, 2, 3)}, 0, Point(1, 2, 3));
}

// A bow tie of two triangles of areas 1 and 1.21, which cancel but for 0.21: the centroid of the signed
// triangles is far outside, at y = 7.4.
void test_crossed_polygon_gives_the_mean_of_the_corners()
{
  check_measures({Point(-1, -1, 0), Point(1.1, 1.1, 0), Point(-1.1, 1.1, 0), Point(1, -1, 0)}, 0.21,
                 Point(0, 0.05, 0));
}

int main()
{
  test_area_vector();
  test_triangle();
  test_polygon_that_is_not_convex();
  test_no_area_gives_the_mean_of_the_corners();
  test_crossed_polygon_gives_the_mean_of_the_corners();
  return check::result();
}
