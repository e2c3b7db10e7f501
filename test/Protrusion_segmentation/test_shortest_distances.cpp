// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortest paths on the face dual graph (Section III.B.2): the algorithm of Floyd and Warshall to
// within rounding, Dijkstra's algorithm of the Boost Graph Library to the last bit.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

using namespace test_meshes;
using CGAL::Protrusion_segmentation::internal::Shortest_distances;

std::vector<double> boost_distances(const Indexed_surface& surface, Index source)
{
  const auto& graph = surface.dual_graph();
  std::vector<double> distances(surface.number_of_faces());
  boost::dijkstra_shortest_paths(
    graph, source,
    boost::weight_map(get(&Indexed_surface::Arc::length, graph))
      .distance_map(boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, graph)))
      .distance_inf(infinity));
  return distances;
}

void check_bitwise(const Test_mesh& mesh, std::size_t number_of_sources = 10)
{
  const Indexed_surface surface = to_surface(mesh);
  Shortest_distances shortest(surface);
  std::vector<double> distances;
  const Index step = Index(1 + (surface.number_of_faces() - 1) / number_of_sources);
  for (Index source = 0; source < surface.number_of_faces(); source += step)
  {
    shortest(source, distances);
    CGAL_CHECK(distances == boost_distances(surface, source));
  }
}

void equals_floyd_warshall()
{
  for (std::uint_fast32_t seed = 0; seed < 20; ++seed)
  {
    const Indexed_surface surface = to_surface(random_surface(seed));
    const auto expected = all_pairs_distances(surface);
    Shortest_distances shortest(surface);
    std::vector<double> distances;
    double error = 0;
    for (Index source = 0; source < surface.number_of_faces(); ++source)
    {
      shortest(source, distances);
      for (std::size_t f = 0; f < distances.size(); ++f)
        error = (std::max)(error, std::abs(distances[f] - expected[source][f]));
    }
    CGAL_CHECK(error < 1e-12);
  }
}

void equals_boost_to_the_last_bit()
{
  for (std::uint_fast32_t seed = 0; seed < 200; ++seed)
    check_bitwise(random_surface(seed));
  check_bitwise(bumpy_sphere(4, 1));
  check_bitwise(capsule_with_ball());
  check_bitwise(moebius_strip());
  check_bitwise(single_triangle());
  check_bitwise(thin_strip(500));
  check_bitwise(triangulated(sheet(40, 30)));
  check_bitwise(triangulated(sheet(1000, 250)), 1);
}

// All arcs have the same length, up to rounding: distances fall on the limits of the buckets.
void equals_boost_where_all_arcs_are_equal()
{
  Random random(7);
  for (int i = 0; i < 300; ++i)
  {
    const double width = random.real(1e-3, 1);
    check_bitwise(sheet(30 + random.index(60), 1 + random.index(60), width, width), 3);
  }
  for (int n : {1, 5, 10})
    check_bitwise(box(n, n, n));
}

// One arc more than 1024 times as long as the mean arc.
void equals_boost_on_needles()
{
  Test_mesh mesh = sheet(3000, 1);
  for (Point& p : mesh.points)
    if (p[0] == 3000)
      p[0] = 1e7;
  check_bitwise(mesh);
  check_bitwise(scaled(bumpy_sphere(3, 2), 1e-6, 1, 1e6));
}

void zero_length_arcs_are_passed()
{
  Test_mesh mesh = sheet(40, 3);
  for (Point& p : mesh.points)
    p[0] = std::floor(p[0] / 3) * 3;
  check_bitwise(mesh);

  check_bitwise(scaled(mesh, 0)); // all faces in one point
  const Indexed_surface point = to_surface(scaled(mesh, 0));
  std::vector<double> distances;
  Shortest_distances shortest(point);
  shortest(5, distances);
  CGAL_CHECK(distances == std::vector<double>(point.number_of_faces(), 0));
}

void other_components_are_unreachable()
{
  const Test_mesh one = icosphere(1);
  const Indexed_surface surface = to_surface(merged({one, translated(one, {5, 0, 0})}));
  std::vector<double> distances;
  Shortest_distances shortest(surface);
  shortest(0, distances);
  for (std::size_t f = 0; f < distances.size(); ++f)
    CGAL_CHECK_EQUAL(distances[f] == Shortest_distances::unreachable(), f >= one.faces.size());
  check_bitwise(merged({one, translated(one, {5, 0, 0})}));
}

// Up to the bound nothing changes; beyond it no distance is too short.
void a_bound_changes_no_distance_within_it()
{
  for (std::uint_fast32_t seed = 0; seed < 50; ++seed)
  {
    const Indexed_surface surface = to_surface(random_surface(seed));
    Shortest_distances shortest(surface);
    std::vector<double> all, bounded;
    shortest(0, all);
    const double range = *std::max_element(all.begin(), all.end());
    for (double bound : {0., range / 10, all[all.size() / 2], range, 2 * range})
    {
      shortest(0, bounded, bound);
      for (std::size_t f = 0; f < all.size(); ++f)
        CGAL_CHECK(all[f] <= bound ? bounded[f] == all[f] : bounded[f] >= all[f]);
    }
    shortest(0, bounded); // and leaves nothing behind
    CGAL_CHECK(all == bounded);
  }
}

void a_bound_saves_work()
{
  const Indexed_surface surface = to_surface(bumpy_sphere(5, 1));
  Shortest_distances shortest(surface);
  std::vector<double> distances;
  shortest(0, distances, 0.2);
  CGAL_CHECK(shortest.number_of_scanned_faces() < surface.number_of_faces() / 20);
}

// Guards the work, not the time: about one scan a face.
void faces_are_scanned_about_once()
{
  for (const Test_mesh& mesh : {bumpy_sphere(5, 1), triangulated(torus(2, 0.5, 200, 60)), sheet(100, 100),
                                height_field(80, 80, 3)})
  {
    const Indexed_surface surface = to_surface(mesh);
    Shortest_distances shortest(surface);
    std::vector<double> distances;
    for (Index source : {Index(0), surface.number_of_faces() / 2})
      shortest(source, distances);
    CGAL_CHECK_EQUAL(shortest.number_of_runs(), 2);
    CGAL_CHECK(double(shortest.number_of_scanned_faces()) <= 2 * 1.25 * surface.number_of_faces());
  }
}

int main()
{
  equals_floyd_warshall();
  equals_boost_to_the_last_bit();
  equals_boost_where_all_arcs_are_equal();
  equals_boost_on_needles();
  zero_length_arcs_are_passed();
  other_components_are_unreachable();
  a_bound_changes_no_distance_within_it();
  a_bound_saves_work();
  faces_are_scanned_about_once();
  return check::result();
}
