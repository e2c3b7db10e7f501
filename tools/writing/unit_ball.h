// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_UNIT_BALL_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_UNIT_BALL_H

#include "reading/Mesh.h"

#include <CGAL/Protrusion_segmentation/internal/Surface/bounding_ball.h>

#include <vector>

namespace tool
{

using CGAL::Protrusion_segmentation::internal::Ball;
using CGAL::Protrusion_segmentation::internal::bounding_ball;

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
