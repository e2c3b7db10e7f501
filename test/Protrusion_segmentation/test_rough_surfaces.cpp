// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces that are full of valleys: how rough they are, and that the valleys of the shape are told from the others.

#include "check.h"
#include "dual_graphs.h"
#include "implicit_mesh.h"
#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/Graphs_of_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Graph/measure_coarse_graph.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace test_meshes;

namespace {

using namespace CGAL::Protrusion_segmentation::internal;

// Points moved along all axes by waves of random directions: by `height` in the mean square, along each.
Test_mesh with_waves(const Test_mesh& mesh, double wavelength, double height, std::uint_fast32_t seed)
{
  constexpr int waves = 40;
  struct Wave
  {
    Point direction;
    double phase;
  };
  Random random(seed);
  std::array<std::vector<Wave>, 3> along;
  for (std::vector<Wave>& of_axis : along)
    for (int i = 0; i < waves; ++i)
    {
      const Point p{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
      of_axis.push_back({(2 * CGAL_PI / wavelength / length(p)) * p, random.real(0, 2 * CGAL_PI)});
    }
  return transformed(mesh,
                     [&](const Point& p)
                     {
                       Point moved = p;
                       for (int axis = 0; axis < 3; ++axis)
                         for (const Wave& wave : along[axis])
                           moved[axis] += height * std::sqrt(2. / waves) * std::sin(dot(wave.direction, p) + wave.phase);
                       return moved;
                     });
}

// Of a length of six, two are concave and not sharp.
void the_root_of_curvature_is_averaged()
{
  Seam_graph graph;
  CGAL_CHECK_EQUAL(roughness(graph), 0.);
  graph.target = {1, 0, 1, 0, 1};
  graph.border_length = {1, 1, 2, 1, 1};
  graph.curvature = {4, 16, -20, 0, 40}; // convex, flat and sharp borders count as length only
  CGAL_CHECK_CLOSE(roughness(graph), 1, 1e-9);
}

void valleys_of_rough_surfaces_say_little()
{
  CGAL_CHECK_EQUAL(weight_of_valleys(0), 1.);
  CGAL_CHECK_CLOSE(weight_of_valleys(1.25), 0.5, 1e-9);
  CGAL_CHECK(weight_of_valleys(0.4) > 0.98);
  CGAL_CHECK(weight_of_valleys(4) < 0.01);
}

double weight(const Test_mesh& mesh)
{
  const Cut_options options;
  return Graphs_of_surface(to_surface(mesh), options, quiet_execution()).coarse.weight_of_valleys;
}

// Whichever side their faces are turned to.
void weights_of_shapes(std::uint_fast32_t seed)
{
  for (const Test_mesh& mesh : {icosphere(5), star(4, 1.5, 0.33, 0, 0.08), box(20, 20, 20)})
  {
    CGAL_CHECK(weight(mesh) > 0.95);
    CGAL_CHECK(weight(with_reversed_orientation(mesh)) > 0.95);
  }
  CGAL_CHECK(weight(with_waves(icosphere(6), 0.4, 0.05, seed)) < 0.2);
}

// They had up to eleven segments.
void rough_balls_are_whole(std::uint_fast32_t seed)
{
  for (const double wavelength : {0.3, 0.4, 0.5})
    CGAL_CHECK_EQUAL(automatic_segmentation(with_waves(icosphere(6), wavelength, wavelength / 8, seed)).number, 1u);
}

void arms_of_rough_balls_are_parts(std::uint_fast32_t seed)
{
  for (const std::size_t arms : {2, 4})
  {
    const Test_mesh mesh = with_waves(star(arms, 1.5, 0.33, 0, 0.08), 0.4, 0.04, seed);
    check_parts(mesh, automatic_segmentation(mesh), 0.92);
  }
}

// A ball with many spines is rough, too.
void spines_are_parts()
{
  constexpr std::size_t spines = 60;
  std::vector<Stick> sticks = {ball({0, 0, 0}, 1, 0)};
  for (std::size_t i = 0; i < spines; ++i)
    sticks.push_back({{0, 0, 0}, 1.5 * spread_direction(i, spines), 0.16, 0.02, i + 1});
  const Test_mesh mesh = implicit_mesh({sticks, 0.04}, 0.05);
  CGAL_CHECK(weight(mesh) < 0.5);
  check_parts(mesh, automatic_segmentation(mesh), 0.9);
}

} // namespace

int main()
{
  the_root_of_curvature_is_averaged();
  valleys_of_rough_surfaces_say_little();
  spines_are_parts();
  for (std::uint_fast32_t seed : {1, 2, 3})
  {
    weights_of_shapes(seed);
    rough_balls_are_whole(seed);
    arms_of_rough_balls_are_parts(seed);
  }
  return check::result();
}
