// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds of sums around a visited face are bounds, closer ones than those by the triangle inequality, and the same with any
// number of threads.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Distances/Face_visitor.h>

#include <algorithm>
#include <set>
#include <vector>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Face_visitor;
using internal::Shortest_distances;
using internal::Visited_face;

constexpr double rounding = 1 + 1e-12;

// Nothing is known before the visit.
Visited_face visit(const Indexed_surface& surface, Index face, bool is_parallel = false)
{
  Shortest_distances distances(surface, is_parallel);
  Face_visitor<Shortest_distances> visitor(distances, surface.number_of_faces(), rounding, is_parallel);
  Visited_face result;
  visitor(face, std::vector<double>(surface.number_of_faces(), infinity), 0, result);
  return result;
}

double sum_from(Shortest_distances& distances, Index face)
{
  std::vector<double> from_face;
  distances(face, from_face);
  return internal::distance_sum(from_face);
}

// Of all faces around the visited one; returns how many are closer.
std::size_t check_bounds(const Indexed_surface& surface, const Visited_face& visit, std::size_t step)
{
  Shortest_distances distances(surface);
  CHECK(visit.has_paths);
  CHECK_CLOSE(visit.of_face.sum, sum_from(distances, visit.face), 1e-9 * visit.of_face.sum);
  const std::vector<Index>& ball = visit.around.faces;
  CHECK_EQUAL(visit.around.bounds.size(), ball.size());
  std::size_t number_of_closer_ones = 0;
  for (std::size_t i = 1; i < ball.size(); i += step)
  {
    CHECK(visit.around.bounds[i] >= sum_from(distances, ball[i]));
    CHECK(visit.around.bounds[i] <= visit.bound(ball[i], rounding));
    number_of_closer_ones += visit.around.bounds[i] < visit.bound(ball[i], rounding);
  }
  return number_of_closer_ones;
}

void bounds_are_bounds()
{
  std::size_t number_of_closer_ones = 0;
  for (std::uint_fast32_t seed = 0; seed < 100; ++seed)
  {
    const Indexed_surface surface = to_surface(random_surface(seed));
    const Visited_face visited = visit(surface, static_cast<Index>(seed % surface.number_of_faces()));
    CHECK_EQUAL(visited.around.faces.size(), surface.number_of_faces() / 2);
    CHECK_EQUAL(visited.around.faces.front(), visited.face);
    CHECK_EQUAL(std::set<Index>(visited.around.faces.begin(), visited.around.faces.end()).size(),
                visited.around.faces.size());
    number_of_closer_ones += check_bounds(surface, visited, 1);
  }
  CHECK(number_of_closer_ones > 100);
}

// What is known to be too small is not looked at.
void without_a_candidate_nothing_is_lowered()
{
  const Indexed_surface surface = to_surface(bumpy_sphere(2, 1));
  Shortest_distances distances(surface);
  Face_visitor<Shortest_distances> visitor(distances, surface.number_of_faces(), rounding, false);
  Visited_face result;
  visitor(5, std::vector<double>(surface.number_of_faces(), 1), 2, result);
  CHECK(std::all_of(result.around.bounds.begin() + 1, result.around.bounds.end(), [](double bound) { return bound == 1; }));
}

// In a ball so large that there are two runs at once.
void in_a_large_ball()
{
  const Indexed_surface surface = to_surface(height_field(272, 256, 1));
  const Visited_face visited = visit(surface, surface.number_of_faces() / 2);
  CHECK_EQUAL(visited.around.faces.size(), surface.number_of_faces() / 32);
  CHECK(check_bounds(surface, visited, 400) > 0);
#ifdef CGAL_LINKED_WITH_TBB
  const Visited_face by_threads = visit(surface, surface.number_of_faces() / 2, true);
  CHECK(by_threads.distances == visited.distances);
  CHECK(by_threads.around.faces == visited.around.faces);
  CHECK(by_threads.around.bounds == visited.around.bounds);
#endif
}

int main()
{
  bounds_are_bounds();
  without_a_candidate_nothing_is_lowered();
  in_a_large_ball();
  return check::result();
}
