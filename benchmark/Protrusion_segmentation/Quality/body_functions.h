// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies as functions that are about the distance to their surface, negative inside.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BODY_FUNCTIONS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BODY_FUNCTIONS_H

#include "test_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace body_functions {

using namespace test_meshes;
using Body = std::function<double(const Point&)>;

inline Body ball(const Point& center, double radius)
{
  return [=](const Point& p) { return length(p - center) - radius; };
}

inline Body ellipsoid(const Point& center, const Point& radii)
{
  return [=](const Point& p)
  {
    Point q = p - center, r = q;
    for (std::size_t i = 0; i < 3; ++i)
    {
      q[i] /= radii[i];
      r[i] = q[i] / radii[i];
    }
    return length(q) * (length(q) - 1) / (std::max)(length(r), 1e-9);
  };
}

// Balls around the points of a path; their radii go from the one to the other.
inline Body tube(std::vector<Point> path, double first_radius, double last_radius)
{
  const double parts = double(path.size()) - 1;
  return [=, path = std::move(path)](const Point& p)
  {
    double nearest = 1e9;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const Point along = path[i + 1] - path[i], to = p - path[i];
      const double t = std::clamp(dot(along, to) / dot(along, along), 0., 1.);
      const double radius = first_radius + (double(i) + t) / parts * (last_radius - first_radius);
      nearest = (std::min)(nearest, length(to - t * along) - radius);
    }
    return nearest;
  };
}

inline Body box(const Point& center, const Point& half_sizes, double rounding = 0.02)
{
  return [=](const Point& p)
  {
    Point outside;
    double inside = -1e9;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double d = std::abs(p[i] - center[i]) - half_sizes[i] + rounding;
      inside = (std::max)(inside, d);
      outside[i] = (std::max)(d, 0.);
    }
    return length(outside) + (std::min)(inside, 0.) - rounding;
  };
}

inline Body cylinder(const Point& from, const Point& to, double radius, double rounding = 0.02)
{
  const Point axis = to - from;
  const double height = length(axis);
  return [=](const Point& p)
  {
    const Point q = p - from;
    const double z = dot(q, axis) / height - height / 2;
    const double r = std::sqrt((std::max)(0., dot(q, q) - (z + height / 2) * (z + height / 2)));
    const double across = r - radius + rounding, along = std::abs(z) - height / 2 + rounding;
    return std::hypot((std::max)(across, 0.), (std::max)(along, 0.)) + (std::min)((std::max)(across, along), 0.) - rounding;
  };
}

inline Body torus(double radius, double thickness)
{
  return [=](const Point& p) { return std::hypot(std::hypot(p[0], p[1]) - radius, p[2]) - thickness; };
}

inline Body without(Body body, Body hole)
{
  return [body = std::move(body), hole = std::move(hole)](const Point& p) { return (std::max)(body(p), -hole(p)); };
}

// The body between the heights -h and h, where the plane z = 0 is in it.
inline Body plate(Body body, double h)
{
  return [=, body = std::move(body)](const Point& p)
  { return (std::max)(body({p[0], p[1], 0}), std::abs(p[2]) - h); };
}

} // namespace body_functions

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_BODY_FUNCTIONS_H
