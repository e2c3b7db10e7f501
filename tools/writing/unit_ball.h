// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_UNIT_BALL_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_UNIT_BALL_H

#include "reading/Mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tool
{

// The ball around the bounding box of points.
struct Ball
{
  std::array<double, 3> center = {0, 0, 0};
  double radius = 1;
};

// Halves are added, so that coordinates near the largest number do not overflow.
inline Ball bounding_ball(const std::vector<Point>& points)
{
  Ball ball;
  std::array<double, 3> half_extents = {0, 0, 0};
  for (int c = 0; c < 3; ++c)
  {
    const auto less = [&](const Point& p, const Point& q) { return p[c] < q[c]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    ball.center[c] = (*low)[c] / 2 + (*high)[c] / 2;
    half_extents[c] = (*high)[c] / 2 - (*low)[c] / 2;
  }
  const double radius = std::hypot(half_extents[0], half_extents[1], half_extents[2]);
  if (radius > 0 && std::isfinite(radius))
    ball.radius = radius;
  return ball;
}

// The coordinates of all points, moved so that the ball becomes the unit ball. There single precision
// is enough for a picture.
inline std::vector<float> positions_in_unit_ball(const std::vector<Point>& points, const Ball& ball)
{
  std::vector<float> result;
  result.reserve(3 * points.size());
  for (const Point& point : points)
    for (int c = 0; c < 3; ++c)
      result.push_back(static_cast<float>((point[c] - ball.center[c]) / ball.radius));
  return result;
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_UNIT_BALL_H
