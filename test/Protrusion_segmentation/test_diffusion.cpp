// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Diffusion of vectors on a graph.

#include "check.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/diffusion.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/conductance.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

internal::Diffusion::Values values_of(const Seam_graph& graph)
{
  internal::Diffusion::Values values(graph.number_of_nodes());
  for (Index f = 0; f < values.size(); ++f)
    values[f] = {{float(f % 3), float(f % 5) / 2, 0.5f, 0}};
  return values;
}

// Diffusion keeps the integral and no value leaves the range of the values; the three coordinates, of which
// the last one is solved at once, do not depend on each other.
void diffusion_keeps_the_mean()
{
  constexpr double tolerance = 1e-4;
  const Seam_graph graph = seam_graph(random_surface(7));
  internal::Diffusion::Values values = values_of(graph);
  internal::Diffusion::Values first_only(values.size());
  for (Index f = 0; f < values.size(); ++f)
    first_only[f] = {{values[f][0], 0, 0, 0}};
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

// (M + time * L) x = M x_0, with the sums written out.
void equations_are_solved()
{
  const double time = 0.01, tolerance = 1e-5;
  const Seam_graph graph = seam_graph(random_surface(8));
  const internal::Diffusion::Values start = values_of(graph);
  internal::Diffusion::Values values = start;
  internal::Diffusion(graph, time)(values, tolerance, quiet_execution());
  const float shortest = static_cast<float>(internal::shortest_length(1, graph.number_of_nodes()));
  double residual = 0, right_hand_side = 0; // their squared norms
  for (Index f = 0; f < values.size(); ++f)
    for (int i = 0; i < 3; ++i)
    {
      double diagonal = graph.area[f], row = graph.area[f] * (values[f][i] - start[f][i]);
      for (Index arc : graph.arcs(f))
      {
        const double weight = time * internal::conductance(graph.border_length[arc], graph.length[arc], shortest);
        diagonal += weight;
        row += weight * (values[f][i] - values[graph.target[arc]][i]);
      }
      residual += row * row / diagonal;
      right_hand_side += CGAL::square(graph.area[f] * start[f][i]) / diagonal;
    }
  CGAL_CHECK(std::sqrt(residual) < 2 * tolerance * std::sqrt(right_hand_side));
}

int main()
{
  diffusion_keeps_the_mean();
  equations_are_solved();
  return check::result();
}
