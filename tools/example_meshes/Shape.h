// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes as functions that are negative inside: smooth unions of tubes and blocks.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_SHAPE_H
#define PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_SHAPE_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace example_shapes
{

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

struct Ball
{
  Point center;
  double radius;
};

inline CGAL::Bbox_3 bbox(const Ball& ball)
{
  const Vector diagonal(ball.radius, ball.radius, ball.radius);
  return (ball.center - diagonal).bbox() + (ball.center + diagonal).bbox();
}

// The hull of two balls, that is all balls between them.
class Cone
{
public:
  Cone(const Ball& from, const Ball& to)
    : m_from(from), m_to(to), m_length(std::sqrt(CGAL::squared_distance(from.center, to.center))),
      m_axis((to.center - from.center) / m_length), m_slope((to.radius - from.radius) / m_length),
      m_lean(m_slope / std::sqrt(1 - m_slope * m_slope))
  {}

  CGAL::Bbox_3 bbox() const { return example_shapes::bbox(m_from) + example_shapes::bbox(m_to); }

  double distance(const Point& p) const
  {
    const Vector v = p - m_from.center;
    const double along = v * m_axis;
    const double across = std::sqrt((std::max)(0., v.squared_length() - along * along));
    const double t = std::clamp(along + across * m_lean, 0., m_length); // of the nearest ball
    return std::sqrt((along - t) * (along - t) + across * across) - (m_from.radius + t * m_slope);
  }

private:
  Ball m_from, m_to;
  double m_length;
  Vector m_axis;
  double m_slope; // below 1: no ball holds the next one
  double m_lean;
};

// A tube around a smooth curve through the centres of `balls`, as thick as these.
class Tube
{
public:
  explicit Tube(const std::vector<Ball>& balls)
  {
    for (std::size_t i = 0; i + 1 < balls.size(); ++i)
      add_span(balls[i == 0 ? 0 : i - 1], balls[i], balls[i + 1],
               balls[(std::min)(i + 2, balls.size() - 1)]);
  }

  CGAL::Bbox_3 bbox() const
  {
    CGAL::Bbox_3 result;
    for (const Span& span : m_spans)
      for (const Cone& cone : span.cones)
        result += cone.bbox();
    return result;
  }

  // Negative inside. What is farther away than `limit` may be reported as `limit`.
  double distance(const Point& p, double limit) const
  {
    for (const Span& span : m_spans)
    {
      // Most of the tube is far away, and the bounding ball tells so at once.
      const double to_bounds = std::sqrt(CGAL::squared_distance(p, span.bounds.center))
                             - span.bounds.radius;
      if (to_bounds < limit)
        for (const Cone& cone : span.cones)
          limit = (std::min)(limit, cone.distance(p));
    }
    return limit;
  }

private:
  struct Span // the curve between two of the given balls
  {
    std::vector<Cone> cones;
    Ball bounds;
  };

  void add_span(const Ball& a, const Ball& b, const Ball& c, const Ball& d)
  {
    const int cones = 8; // the corners between them cannot be seen any more
    Span span{{}, {CGAL::midpoint(b.center, c.center), 0}};
    Ball last = b;
    for (int i = 0; i <= cones; ++i)
    {
      const Ball next = spline(a, b, c, d, double(i) / cones);
      const double center_distance = std::sqrt(CGAL::squared_distance(span.bounds.center,
                                                                      next.center));
      span.bounds.radius = (std::max)(span.bounds.radius, center_distance + next.radius);
      if (i > 0)
        span.cones.emplace_back(last, next);
      last = next;
    }
    m_spans.push_back(std::move(span));
  }

  // A Catmull-Rom spline from b (t = 0) to c (t = 1).
  static Ball spline(const Ball& a, const Ball& b, const Ball& c, const Ball& d, double t)
  {
    const double u = t * t, v = t * u;
    const double wa = (-t + 2 * u - v) / 2, wb = (2 - 5 * u + 3 * v) / 2;
    const double wc = (t + 4 * u - 3 * v) / 2, wd = (v - u) / 2;
    return {CGAL::barycenter(a.center, wa, b.center, wb, c.center, wc, d.center, wd),
            wa * a.radius + wb * b.radius + wc * c.radius + wd * d.radius};
  }

  std::vector<Span> m_spans;
};

// A box with rounded edges, parallel to the axes.
struct Block
{
  Point center;
  Vector half_size;
  double rounding;

  CGAL::Bbox_3 bbox() const { return (center - half_size).bbox() + (center + half_size).bbox(); }

  double distance(const Point& p) const
  {
    double squared_outside = 0, inside = -(std::numeric_limits<double>::max)();
    for (int i = 0; i < 3; ++i)
    {
      const double d = std::abs(p[i] - center[i]) - (half_size[i] - rounding);
      squared_outside += d > 0 ? d * d : 0;
      inside = (std::max)(inside, d);
    }
    return std::sqrt(squared_outside) + (std::min)(inside, 0.) - rounding;
  }
};

struct Shape
{
  std::vector<Tube> tubes;
  std::vector<Block> blocks;
  double blend; // size of the fillets where tubes and blocks meet

  void add(const std::vector<Ball>& balls) { tubes.emplace_back(balls); }

  // A tube and its mirror image in the plane y = 0.
  void add_pair(std::vector<Ball> balls)
  {
    add(balls);
    for (Ball& ball : balls)
      ball.center = Point(ball.center.x(), -ball.center.y(), ball.center.z());
    add(balls);
  }

  // Holds the surface. Where n parts meet, their fillets lie at most blend * log(n) farther out.
  CGAL::Bbox_3 bbox() const
  {
    CGAL::Bbox_3 result;
    for (const Block& block : blocks)
      result += block.bbox();
    for (const Tube& tube : tubes)
      result += tube.bbox();
    const double fillet = blend * std::log(double(blocks.size() + tubes.size()));
    const Vector diagonal(fillet, fillet, fillet);
    const Point low(result.xmin(), result.ymin(), result.zmin());
    const Point high(result.xmax(), result.ymax(), result.zmax());
    return (low - diagonal).bbox() + (high + diagonal).bbox();
  }

  // Negative inside: a smooth minimum of all distances.
  double operator()(const Point& p) const
  {
    // What is farther away than the nearest by this many fillets no longer counts: exp(-20) is
    // below the accuracy of the mesh.
    const double reach = 20 * blend;
    double nearest = std::numeric_limits<double>::infinity();
    std::vector<double> distances;
    auto add_distance = [&](double distance)
    {
      distances.push_back(distance);
      nearest = (std::min)(nearest, distance);
    };
    for (const Block& block : blocks)
      add_distance(block.distance(p));
    for (const Tube& tube : tubes)
      add_distance(tube.distance(p, nearest + reach));

    double sum = 0;
    for (double distance : distances)
      sum += std::exp((nearest - distance) / blend);
    return nearest - blend * std::log(sum);
  }
};

} // namespace example_shapes

#endif // PROTRUSION_SEGMENTATION_TOOLS_EXAMPLE_MESHES_SHAPE_H
