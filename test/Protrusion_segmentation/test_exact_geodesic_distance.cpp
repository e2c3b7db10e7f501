// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact distance over the surface against analytic distances.

#include "test_distances.h"

#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

void check_euclidean(const Test_mesh& mesh, Index source)
{
  const Indexed_surface surface = to_surface(mesh);
  auto distances = Exact_geodesic_distance().on(surface, quiet_execution());
  std::vector<double> row;
  distances(source, row);
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    CGAL_CHECK_CLOSE(row[f], std::sqrt(squared_distance(surface.centroid(source), surface.centroid(f))), 1e-9);
}

void distances_on_a_plane_are_euclidean()
{
  for (Index source : {0, 11, 140})
  {
    check_euclidean(triangulated(sheet(12, 9)), source);
    check_euclidean(rotated(triangulated(sheet(12, 9)), {1, 2, 3}, 1), source);
  }
  check_euclidean(sheet(12, 9), 40); // polygons too
}

// Over the edges of a cube the way is straight where the faces are unfolded.
void distances_on_a_cube_are_those_of_its_nets()
{
  const Indexed_surface surface = to_surface(box());
  const auto d = distance_matrix(surface, Exact_geodesic_distance());
  for (Index f = 0; f < 6; ++f)
    for (Index g = 0; g < 6; ++g)
    {
      const double straight = std::sqrt(squared_distance(surface.centroid(f), surface.centroid(g)));
      CGAL_CHECK_CLOSE(d[f][g], f == g ? 0. : straight < 0.9 ? 1. : 2., 1e-9);
    }
}

// The side of a prism is a rolled up rectangle. Its faces' centroids are in the middle of the sides; ways
// over the caps are longer where the prism is high.
void distances_on_a_prism_are_those_of_its_net()
{
  const std::size_t n = 9;
  const Indexed_surface surface = to_surface(regular_prism(n, 1, 12));
  auto distances = Exact_geodesic_distance().on(surface, quiet_execution());
  std::vector<double> row;
  std::vector<Index> sides;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    if (surface.first_corner(f + 1) - surface.first_corner(f) == 4)
      sides.push_back(f);
  CGAL_CHECK_EQUAL(sides.size(), n);
  distances(sides[0], row);
  for (std::size_t i = 0; i < n; ++i)
    CGAL_CHECK_CLOSE(row[sides[i]], double((std::min)(i, n - i)) * 2 * std::sin(pi / double(n)), 1e-9);
}

// The mesh lies inside the sphere, by two hundredths.
void distances_on_a_sphere_are_arcs()
{
  const Indexed_surface surface = to_surface(icosphere(2));
  auto distances = Exact_geodesic_distance().on(surface, quiet_execution());
  std::vector<double> row;
  distances(100, row);
  const auto direction = [&](Index f)
  {
    const Indexed_surface::Vector_3 v = surface.centroid(f) - Indexed_surface::Point_3(0, 0, 0);
    return v / std::sqrt(v.squared_length());
  };
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    const double arc = std::acos((std::max)(-1., (std::min)(1., direction(100) * direction(f))));
    CGAL_CHECK_CLOSE(row[f], arc, 0.03 * arc + 1e-9);
  }
}

// Paths over the faces are shorter than paths from centroid to centroid, but for corners cut in space.
void no_longer_than_paths_in_the_dual_graph()
{
  const Indexed_surface surface = to_surface(height_field(8, 8, 2));
  const auto exact = distance_matrix(surface, Exact_geodesic_distance());
  const auto dual = distance_matrix(surface, Geodesic_distance());
  double exact_sum = 0, dual_sum = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    exact_sum += internal::distance_sum(exact[i]);
    dual_sum += internal::distance_sum(dual[i]);
  }
  CGAL_CHECK(exact_sum < dual_sum);
  CGAL_CHECK(exact_sum > 0.6 * dual_sum);
}

int main()
{
  distances_on_a_plane_are_euclidean();
  distances_on_a_cube_are_those_of_its_nets();
  distances_on_a_prism_are_those_of_its_net();
  distances_on_a_sphere_are_arcs();
  no_longer_than_paths_in_the_dual_graph();
  check_is_a_metric(Exact_geodesic_distance(), 1e-9);
  check_search_finds_the_largest_sum(Exact_geodesic_distance(), 1e-9);
  check_survives_awkward_surfaces(Exact_geodesic_distance());
  check_segments_stars(Exact_geodesic_distance(), 3, 0.35);
  return check::result();
}
