// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Averages over the faces, also by way of disks.

#include "check.h"
#include "dual_graphs.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Surface_average.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;
using internal::Padded_vectors;
using internal::Surface_average;

// The same average, the long way.
Padded_vectors average_without_disks(const Seam_graph& graph, Padded_vectors values, double radius)
{
  internal::Diffusion diffuse(graph, radius * radius / 16);
  for (int step = 0; step < 2; ++step)
    diffuse(values, 1e-5, quiet_execution());
  return values;
}

// A step, a wave and a constant.
Padded_vectors values_of(const Indexed_surface& surface)
{
  Padded_vectors values;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    values.push_back({{surface.centroid(f).z() > 0 ? 1.f : 0.f, float(std::sin(4 * surface.centroid(f).x())), 1.f, 0.f}});
  return values;
}

void check_average(const Seam_graph& graph, const Padded_vectors& found, const Padded_vectors& expected)
{
  for (int i = 0; i < 3; ++i)
  {
    double squares = 0, largest = 0;
    for (Index f = 0; f < graph.number_of_nodes(); ++f)
    {
      const double error = std::abs(found[f][i] - expected[f][i]);
      squares += graph.area[f] * error * error;
      largest = (std::max)(largest, error);
    }
    std::cout << "value " << i << ": " << std::sqrt(squares) << ", " << largest << "\n";
    CGAL_CHECK(std::sqrt(squares) < (i == 2 ? 1e-3 : 0.03));
    CGAL_CHECK(largest < 0.1);
  }
}

// Where faces are small, disks of them, or disks of disks, are averaged: that is the same, as far as discrete operators of different
// meshes agree.
void disks_average_like_faces()
{
  const Indexed_surface surface = to_surface(jittered(icosphere(6), 0.001, 3));
  const Seam_graph graph = seam_graph(surface);
  const Centres centre = centres(surface);
  const Surface_average finer(graph, centre, 0.1 / 9, quiet_execution());
  for (const double radius : {0.1, 0.2, 0.3})
  {
    const Padded_vectors expected = average_without_disks(graph, values_of(surface), radius);
    Padded_vectors by_disks = values_of(surface), by_disks_of_disks = by_disks, by_finer_disks = by_disks;
    Surface_average(graph, centre, radius / 9, quiet_execution())(by_disks, radius);
    Surface_average(finer, radius / 9)(by_disks_of_disks, radius);
    finer(by_finer_disks, radius);
    for (const Padded_vectors* found : {&by_disks, &by_disks_of_disks, &by_finer_disks})
      check_average(graph, *found, expected);
  }
}

// There would be more disks than faces.
void large_faces_make_no_disks()
{
  const Indexed_surface surface = to_surface(icosphere(1));
  const Seam_graph graph = seam_graph(surface);
  const Centres centre = centres(surface);
  Padded_vectors values = values_of(surface);
  Surface_average(graph, centre, 0.1 / 9, quiet_execution())(values, 0.1);
  check_average(graph, values, average_without_disks(graph, values_of(surface), 0.1));
}

int main()
{
  disks_average_like_faces();
  large_faces_make_no_disks();
  return check::result();
}
