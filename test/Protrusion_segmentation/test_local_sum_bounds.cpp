// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds of sums around a visited face are bounds, and closer ones than those by the triangle inequality.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>

#include <algorithm>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Local_sum_bounds;
using internal::Shortest_distances;

constexpr double rounding = 1 + 1e-12;

double sum_from(Shortest_distances& distances, Index face)
{
  std::vector<double> from_face;
  distances(face, from_face);
  return internal::distance_sum(from_face);
}

// What is known of the sums after a visit.
struct Visit
{
  std::vector<double> by_triangle_inequality;
  std::vector<double> lowered;
};

Visit visit(const Indexed_surface& surface, Index face)
{
  const Index n = surface.number_of_faces();
  Shortest_distances distances(surface);
  std::vector<double> from_face;
  distances(face, from_face);
  const double sum = internal::distance_sum(from_face);
  Visit result;
  for (const double distance : from_face)
    result.by_triangle_inequality.push_back((sum + n * distance) * rounding);
  result.lowered = result.by_triangle_inequality;
  Local_sum_bounds(n, rounding).lower(distances, from_face, sum, sum, result.lowered);
  return result;
}

// Of every `step`-th face; returns how many are lower than by the triangle inequality.
std::size_t check_bounds(const Indexed_surface& surface, const Visit& visit, Index step)
{
  Shortest_distances distances(surface);
  std::size_t number_of_closer_ones = 0;
  for (Index f = 0; f < surface.number_of_faces(); f += step)
  {
    CGAL_CHECK(visit.lowered[f] >= sum_from(distances, f));
    CGAL_CHECK(visit.lowered[f] <= visit.by_triangle_inequality[f]);
    number_of_closer_ones += visit.lowered[f] < visit.by_triangle_inequality[f];
  }
  return number_of_closer_ones;
}

void bounds_are_bounds()
{
  std::size_t number_of_closer_ones = 0;
  for (std::uint_fast32_t seed = 0; seed < 100; ++seed)
  {
    const Indexed_surface surface = to_surface(random_surface(seed));
    number_of_closer_ones += check_bounds(
      surface, visit(surface, static_cast<Index>(seed % surface.number_of_faces())), 1);
  }
  CGAL_CHECK(number_of_closer_ones > 100);
}

// What is known to be too small is not looked at.
void without_a_candidate_nothing_is_lowered()
{
  const Indexed_surface surface = to_surface(bumpy_sphere(2, 1));
  Shortest_distances distances(surface);
  std::vector<double> from_face, bounds(surface.number_of_faces(), 1);
  distances(5, from_face);
  Local_sum_bounds(surface.number_of_faces(), rounding).lower(distances, from_face, 2, 2, bounds);
  CGAL_CHECK(bounds == std::vector<double>(surface.number_of_faces(), 1));
}

// In a ball of a 32nd of the surface.
void only_faces_near_the_visited_one_are_looked_at()
{
  const Indexed_surface surface = to_surface(height_field(272, 256, 1));
  const Visit result = visit(surface, surface.number_of_faces() / 2);
  std::size_t number_of_closer_ones = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    number_of_closer_ones += result.lowered[f] < result.by_triangle_inequality[f];
  CGAL_CHECK(number_of_closer_ones > 0);
  CGAL_CHECK(number_of_closer_ones <= surface.number_of_faces() / 32);
  check_bounds(surface, result, 1000);
}

int main()
{
  bounds_are_bounds();
  without_a_candidate_nothing_is_lowered();
  only_faces_near_the_visited_one_are_looked_at();
  return check::result();
}
