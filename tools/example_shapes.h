// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shapes of make_example_mesh.cpp: functions that are negative inside, smooth unions of tubes
// and blocks.

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_EXAMPLE_SHAPES_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_EXAMPLE_SHAPES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace example_shapes
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

// Of a ball around the origin that holds every shape.
constexpr double bounding_radius = 5;

struct Ball
{
  Point center;
  double radius;
};

// The hull of two balls, that is all balls between them.
class Cone
{
public:
  Cone(const Ball& from, const Ball& to)
    : m_from(from), m_length(std::sqrt(CGAL::squared_distance(from.center, to.center))),
      m_axis((to.center - from.center) / m_length), m_slope((to.radius - from.radius) / m_length),
      m_lean(m_slope / std::sqrt(1 - m_slope * m_slope))
  {}

  double distance(const Point& p) const
  {
    const Vector v = p - m_from.center;
    const double along = v * m_axis;
    const double across = std::sqrt(std::max(0., v.squared_length() - along * along));
    const double t = std::clamp(along + across * m_lean, 0., m_length); // of the nearest ball
    return std::sqrt((along - t) * (along - t) + across * across) - (m_from.radius + t * m_slope);
  }

private:
  Ball m_from;
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
    for(std::size_t i = 0; i + 1 < balls.size(); ++i)
      add_span(balls[i == 0 ? 0 : i - 1], balls[i], balls[i + 1],
               balls[std::min(i + 2, balls.size() - 1)]);
  }

  // Negative inside. What is farther away than `limit` may be reported as `limit`.
  double distance(const Point& p, double limit) const
  {
    for(const Span& span : m_spans)
    {
      // Most of the tube is far away, and the bounding ball tells so at once.
      const double to_bounds = std::sqrt(CGAL::squared_distance(p, span.bounds.center))
                             - span.bounds.radius;
      if(to_bounds < limit)
        for(const Cone& cone : span.cones)
          limit = std::min(limit, cone.distance(p));
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
    for(int i = 0; i <= cones; ++i)
    {
      const Ball next = spline(a, b, c, d, double(i) / cones);
      const double center_distance = std::sqrt(CGAL::squared_distance(span.bounds.center,
                                                                      next.center));
      span.bounds.radius = std::max(span.bounds.radius, center_distance + next.radius);
      if(i > 0)
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

  double distance(const Point& p) const
  {
    double squared_outside = 0, inside = -std::numeric_limits<double>::max();
    for(int i = 0; i < 3; ++i)
    {
      const double d = std::abs(p[i] - center[i]) - (half_size[i] - rounding);
      squared_outside += d > 0 ? d * d : 0;
      inside = std::max(inside, d);
    }
    return std::sqrt(squared_outside) + std::min(inside, 0.) - rounding;
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
    for(Ball& ball : balls)
      ball.center = Point(ball.center.x(), -ball.center.y(), ball.center.z());
    add(balls);
  }

  // Negative inside: a smooth minimum of all distances.
  double operator()(const Point& p) const
  {
    // What is farther away than the nearest by this many fillets no longer counts: exp(-20) is
    // below the accuracy of the mesh.
    const double reach = 20 * blend;
    double nearest = 2 * bounding_radius;
    std::vector<double> distances;
    auto add_distance = [&](double distance)
    {
      distances.push_back(distance);
      nearest = std::min(nearest, distance);
    };
    for(const Block& block : blocks)
      add_distance(block.distance(p));
    for(const Tube& tube : tubes)
      add_distance(tube.distance(p, nearest + reach));

    double sum = 0;
    for(double distance : distances)
      sum += std::exp((nearest - distance) / blend);
    return nearest - blend * std::log(sum);
  }
};

inline Shape octopus()
{
  Shape shape{{}, {}, 0.07};
  shape.add({{{0, 0, 0.35}, 0.7}, {{-0.1, 0, 1.0}, 0.72}, {{-0.45, 0, 1.9}, 0.95}}); // head
  shape.add_pair({{{0.5, 0.4, 0.95}, 0.22}, {{0.62, 0.46, 1.0}, 0.18}});             // eyes
  for(int i = 0; i < 8; ++i)
  {
    // No two arms alike: each ends in a curl of its own.
    const double turn = CGAL_PI * (i + 0.5) / 4, curl = 0.55 + 0.12 * std::sin(2.4 * i);
    const double reach = 1 + 0.06 * std::cos(1.7 * i);
    auto at = [&](double r, double side, double z)
    {
      const double angle = turn + side * curl;
      return Point(r * reach * std::cos(angle), r * reach * std::sin(angle), z);
    };
    shape.add({{at(0.3, 0, 0.2), 0.36}, {at(1.0, 0, -0.25), 0.31}, {at(1.8, 0.05, -0.6), 0.25},
               {at(2.6, 0.25, -0.5), 0.2}, {at(3.2, 0.55, -0.15), 0.15},
               {at(3.3, 0.9, 0.35), 0.11}, {at(2.9, 1.1, 0.5), 0.07}});
  }
  return shape;
}

inline Shape teddy()
{
  Shape shape{{}, {}, 0.05};
  shape.add({{{0, 0, -0.1}, 0.95}, {{0, 0, 0.3}, 0.97}, {{0, 0, 0.85}, 0.72}});         // trunk
  shape.add({{{0.02, 0, 2.05}, 0.8}, {{0.1, 0, 2.0}, 0.8}});                            // head
  shape.add({{{0.6, 0, 1.85}, 0.36}, {{0.9, 0, 1.8}, 0.27}});                           // snout
  shape.add_pair({{{0, 0.62, 2.65}, 0.28}, {{-0.02, 0.72, 2.8}, 0.27}});                // ears
  shape.add_pair({{{0.05, 0.6, 0.95}, 0.3}, {{0.35, 1.25, 0.65}, 0.32}, {{0.8, 1.6, 0.5}, 0.34}});
  shape.add_pair({{{0.2, 0.5, -0.55}, 0.4}, {{0.9, 0.75, -0.75}, 0.4}, {{1.5, 0.9, -0.75}, 0.4},
                  {{1.65, 0.92, -0.45}, 0.34}});                                        // legs
  return shape;
}

inline Shape hand()
{
  Shape shape{{}, {}, 0.06};
  shape.add({{{0, 0, -1.5}, 0.5}, {{0, 0, -0.7}, 0.44}, {{0, 0, 0.1}, 0.5}}); // wrist
  const double lengths[] = {1.6, 1.85, 1.65, 1.25};
  for(int i = 0; i < 4; ++i) // each finger with its part of the palm
  {
    const double y = 0.84 - 0.56 * i, z = 1.5 - 0.08 * std::abs(i - 1), length = lengths[i];
    shape.add({{{0, 0.35 * y, 0.1}, 0.42}, {{0, 0.8 * y, 0.9}, 0.34}, {{0, y, z}, 0.25},
               {{0.02, 1.2 * y, z + 0.55 * length}, 0.21}, {{0.2, 1.35 * y, z + length}, 0.16}});
  }
  shape.add({{{0.05, 0.2, 0.1}, 0.4}, {{0.15, 0.75, 0.5}, 0.33}, {{0.25, 1.35, 0.95}, 0.25},
             {{0.3, 1.75, 1.5}, 0.18}}); // thumb
  return shape;
}

inline Shape horse()
{
  Shape shape{{}, {}, 0.05};
  shape.add({{{-1.1, 0, 0}, 0.6}, {{0, 0, -0.05}, 0.56}, {{1.0, 0, 0.02}, 0.6}});          // trunk
  shape.add({{{1.1, 0, 0.2}, 0.42}, {{1.7, 0, 0.95}, 0.3}, {{2.05, 0, 1.55}, 0.25}});      // neck
  shape.add({{{2.0, 0, 1.6}, 0.29}, {{2.5, 0, 1.25}, 0.22}, {{2.8, 0, 1.02}, 0.18}});      // head
  shape.add_pair({{{1.95, 0.14, 1.8}, 0.1}, {{1.95, 0.18, 2.1}, 0.05}});                   // ears
  shape.add_pair({{{1.1, 0.3, -0.1}, 0.3}, {{1.15, 0.34, -0.9}, 0.19}, {{1.12, 0.34, -1.5}, 0.14},
                  {{1.12, 0.34, -2.1}, 0.13}, {{1.2, 0.34, -2.25}, 0.16}});                // front
  shape.add_pair({{{-1.2, 0.3, -0.05}, 0.34}, {{-1.2, 0.34, -0.8}, 0.23},
                  {{-1.45, 0.34, -1.45}, 0.14}, {{-1.35, 0.34, -2.1}, 0.13},
                  {{-1.27, 0.34, -2.25}, 0.16}});                                          // hind
  shape.add({{{-1.6, 0, 0.25}, 0.16}, {{-2.0, 0, 0.15}, 0.15}, {{-2.25, 0, -0.4}, 0.16},
             {{-2.3, 0, -1.1}, 0.07}});                                                    // tail
  return shape;
}

inline Shape chair()
{
  Shape shape{{}, {}, 0.03};
  shape.blocks.push_back({{0, 0, 0}, {1.1, 1.1, 0.14}, 0.12});       // seat
  shape.blocks.push_back({{-1.17, 0, 1.85}, {0.1, 0.95, 0.42}, 0.1}); // back
  shape.add_pair({{{-0.95, 0.9, 0}, 0.13}, {{-1.1, 0.9, 1.1}, 0.12}, {{-1.2, 0.9, 2.3}, 0.12}});
  shape.add_pair({{{-0.95, 0.9, 0}, 0.15}, {{-1.05, 0.95, -1.0}, 0.13}, {{-1.2, 1.0, -2.0}, 0.1}});
  shape.add_pair({{{0.9, 0.9, 0}, 0.15}, {{0.95, 0.95, -1.0}, 0.13}, {{1.05, 1.0, -2.05}, 0.1}});
  return shape;
}

} // namespace example_shapes

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_EXAMPLE_SHAPES_H
