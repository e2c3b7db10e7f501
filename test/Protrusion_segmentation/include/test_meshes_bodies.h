// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies with protrusions: closed triangle meshes, blended where the parts meet. By default they
// have 5,000 to 15,000 faces; `cell` is twice the length of an edge.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_BODIES_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_BODIES_H

#include "implicit_mesh.h"

namespace test_meshes {

// The i-th of n directions spread over the sphere (on a spiral), no two of them opposite.
inline Point spread_direction(std::size_t i, std::size_t n)
{
  const double golden_angle = 2.39996322972865332;
  const double z = 1 - (2 * double(i) + 1) / double(n);
  const double r = std::sqrt(1 - z * z), turn = golden_angle * double(i);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

// A ball of radius 1 with `arms` sticks. Arm i reaches `arm_length` * (1 + i * `length_step`) out
// of the ball: with a positive step no two arms tie. Parts: 0 the ball, 1 + i the i-th arm.
Test_mesh star(std::size_t arms,
               double arm_length = 2,
               double arm_radius = 0.25,
               double length_step = 0.04,
               double cell = 0.22);

// Equal sticks in a plane that meet in a ball hardly wider than they are. Parts: 0 the ball, 1 + i the i-th arm.
Test_mesh star_of_equal_arms(std::size_t arms, double arm_length = 1.2, double arm_radius = 0.2, double cell = 0.12);

// A trunk with four legs, and a neck with a head at its +x end.
// Parts: 0 the trunk, 1 to 4 the legs (one a bit longer than the other), 5 the neck and the head.
Test_mesh creature(double cell = 0.16);

// A ball of radius 1 with two arms along -x and +x that end in palms with `fingers` fingers each:
// protrusions on protrusions; up to four fingers have room. Parts: 0 the ball, then for each arm
// the arm with its palm followed by its fingers.
Test_mesh body_with_hands(std::size_t fingers = 3, double cell = 0.13);

#ifndef CGAL_PROTRUSION_SEGMENTATION_COMPILED_DISTANCES

CGAL_PROTRUSION_SEGMENTATION_INLINE Test_mesh
star(std::size_t arms, double arm_length, double arm_radius, double length_step, double cell)
{
  std::vector<Stick> sticks = {ball({0, 0, 0}, 1, 0)};
  for (std::size_t i = 0; i < arms; ++i)
  {
    const double reach = 1 + arm_length * (1 + double(i) * length_step) - arm_radius;
    sticks.push_back({{0, 0, 0}, reach * spread_direction(i, arms), arm_radius, arm_radius, i + 1});
  }
  return implicit_mesh(Implicit_body(sticks, 0.03), cell);
}

CGAL_PROTRUSION_SEGMENTATION_INLINE Test_mesh
star_of_equal_arms(std::size_t arms, double arm_length, double arm_radius, double cell)
{
  std::vector<Stick> sticks = {ball({0, 0, 0}, 1.25 * arm_radius, 0)};
  for (std::size_t i = 0; i < arms; ++i)
  {
    const double angle = 2 * pi * double(i) / double(arms);
    sticks.push_back({{0, 0, 0}, {arm_length * std::cos(angle), arm_length * std::sin(angle), 0}, arm_radius, arm_radius, i + 1});
  }
  return implicit_mesh(Implicit_body(sticks, 0.04), cell);
}

CGAL_PROTRUSION_SEGMENTATION_INLINE Test_mesh creature(double cell)
{
  std::vector<Stick> sticks = {{{-1, 0, 0}, {1, 0, 0}, 0.55, 0.55, 0}};
  std::size_t part = 1;
  for (double x : {-1.1, 1.1})
    for (double y : {-0.35, 0.35})
    {
      const double foot = -1.9 - 0.03 * double(part);
      sticks.push_back({{x, y, -0.2}, {1.1 * x, 1.2 * y, foot}, 0.2, 0.16, part++});
    }
  sticks.push_back({{1.2, 0, 0.2}, {2.1, 0, 1.3}, 0.25, 0.2, 5});
  sticks.push_back({{2.15, 0, 1.45}, {2.5, 0, 1.35}, 0.36, 0.28, 5});
  return implicit_mesh(Implicit_body(sticks, 0.04), cell);
}

CGAL_PROTRUSION_SEGMENTATION_INLINE Test_mesh body_with_hands(std::size_t fingers, double cell)
{
  std::vector<Stick> sticks = {ball({0, 0, 0}, 1, 0)};
  std::size_t part = 1;
  for (double side : {-1., 1.})
  {
    const Point palm = {side * 3.2, 0, 0};
    sticks.push_back({{0, 0, 0}, palm, 0.25, 0.25, part});
    sticks.push_back(ball(palm, 0.6, part++));
    for (std::size_t i = 0; i < fingers; ++i)
    {
      const double turn = fingers < 2 ? 0 : -1.2 + 2.4 * double(i) / double(fingers - 1);
      const double reach = 1.7 + 0.05 * double(i) + (side > 0 ? 0.02 : 0.);
      const Point direction = {side * std::cos(turn), std::sin(turn), 0};
      sticks.push_back({palm, palm + reach * direction, 0.14, 0.12, part++});
    }
  }
  return implicit_mesh(Implicit_body(sticks, 0.03), cell);
}

#endif // CGAL_PROTRUSION_SEGMENTATION_COMPILED_DISTANCES

} // namespace test_meshes

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_TEST_MESHES_BODIES_H
