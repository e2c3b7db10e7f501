// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Averages of vectors over the surface.

#include "check.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/diffusion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

// The same average, the long way.
internal::Diffusion::Values average_without_groups(const Seam_graph& graph,
                                                   internal::Diffusion::Values values,
                                                   double radius)
{
  internal::Diffusion diffuse(graph, radius * radius / 16);
  for (int step = 0; step < 2; ++step)
    diffuse(values, 1e-5, quiet_execution());
  return values;
}

// Where faces are small for the radius they are averaged in groups, and groups of groups. A step, a wave and a constant
// come out as without groups, as far as discrete operators of different meshes agree.
void groups_of_faces_average_like_faces()
{
  const Indexed_surface surface = to_surface(jittered(icosphere(5), 0.002, 3));
  const Seam_graph graph = seam_graph(surface);
  for (const double radius : {0.2, 0.3})
  {
    CGAL_CHECK(surface.number_of_faces() > 8 * std::pow(6 / radius, 2)); // two levels of groups
    internal::Diffusion::Values values;
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      values.push_back(
        {surface.centroid(f).z() > 0 ? 1.f : 0.f, float(std::sin(4 * surface.centroid(f).x())), 1.f, 0.f});
    const auto expected = average_without_groups(graph, values, radius);
    internal::Multilevel_diffusion(radius, quiet_execution())(graph, centres(surface), values);
    for (int i = 0; i < 3; ++i)
    {
      double squares = 0, largest = 0;
      for (Index f = 0; f < surface.number_of_faces(); ++f)
      {
        const double error = std::abs(values[f][i] - expected[f][i]);
        squares += graph.area[f] * error * error;
        largest = (std::max)(largest, error);
      }
      std::cout << "radius " << radius << ", value " << i << ": " << std::sqrt(squares) << ", " << largest
                << "\n";
      CGAL_CHECK(std::sqrt(squares) < (i == 2 ? 1e-3 : 0.03));
      CGAL_CHECK(largest < 0.1);
    }
  }
}

// Diffusion keeps the integral and no value leaves the range of the values; the three coordinates, of which
// the last one is solved at once, do not depend on each other.
void diffusion_keeps_the_mean()
{
  constexpr double tolerance = 1e-4;
  const Seam_graph graph = seam_graph(random_surface(7));
  internal::Diffusion::Values values(graph.number_of_nodes());
  for (Index f = 0; f < values.size(); ++f)
    values[f] = {float(f % 3), float(f % 5) / 2, 0.5f, 0};
  internal::Diffusion::Values first_only(values.size());
  for (Index f = 0; f < values.size(); ++f)
    first_only[f] = {values[f][0], 0, 0, 0};
  const internal::Diffusion::Values start = values;
  internal::Diffusion diffuse(graph, 0.01);
  diffuse(values, tolerance, quiet_execution());
  diffuse(first_only, tolerance, quiet_execution());
  std::array<double, 3> before = {0, 0, 0}, after = {0, 0, 0};
  for (Index f = 0; f < values.size(); ++f)
  {
    CGAL_CHECK_EQUAL(values[f][0], first_only[f][0]);
    CGAL_CHECK_EQUAL(first_only[f][1], 0);
    CGAL_CHECK_CLOSE(values[f][2], 0.5, 1e-5);
    for (int i = 0; i < 3; ++i)
    {
      before[i] += graph.area[f] * start[f][i];
      after[i] += graph.area[f] * values[f][i];
      CGAL_CHECK(values[f][i] > -0.01 && values[f][i] < 2.01);
    }
  }
  for (int i = 0; i < 3; ++i)
    CGAL_CHECK_CLOSE(after[i], before[i], 1e-2 * before[i]);
}

int main()
{
  groups_of_faces_average_like_faces();
  diffusion_keeps_the_mean();
  return check::result();
}
