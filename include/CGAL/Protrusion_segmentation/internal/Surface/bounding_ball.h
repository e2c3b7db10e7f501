// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_BOUNDING_BALL_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_BOUNDING_BALL_H

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The ball around the bounding box of points, if there are any.
struct Ball
{
  std::array<double, 3> center = {0, 0, 0};
  double radius = 1;
};

// Halves are added, so that coordinates near the largest number do not overflow.
inline Ball bounding_ball(const std::vector<Simple_cartesian<double>::Point_3>& points)
{
  Ball ball;
  if (points.empty())
    return ball;
  std::array<double, 3> half_extents = {0, 0, 0};
  for (int c = 0; c < 3; ++c)
  {
    const auto less = [&](const auto& p, const auto& q) { return p[c] < q[c]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    ball.center[c] = (*low)[c] / 2 + (*high)[c] / 2;
    half_extents[c] = (*high)[c] / 2 - (*low)[c] / 2;
  }
  const double radius = std::hypot(half_extents[0], half_extents[1], half_extents[2]);
  if (radius > 0 && std::isfinite(radius))
    ball.radius = radius;
  return ball;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_BOUNDING_BALL_H
