// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_SEEN_CAP_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_SEEN_CAP_H

#include <CGAL/Protrusion_segmentation/internal/Closing/Capper.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Cap_frame.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Prism.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/squared_distance_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::connectors {

struct Circle
{
  Point_2 center = Point_2(0, 0);
  double radius = 0;
};

// The distance of a point from a polygon; negative outside of it.
inline double depth_in(const std::vector<Point_2>& polygon, const Point_2& p)
{
  double least = (std::numeric_limits<double>::max)();
  bool is_inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point_2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    least = (std::min)(least, CGAL::squared_distance(p, Kernel::Segment_2(a, b)));
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (b.x() - a.x()) * ((p.y() - a.y()) / (b.y() - a.y())))
      is_inside = !is_inside;
  }
  return is_inside ? std::sqrt(least) : -std::sqrt(least);
}

// The largest circle in a simple polygon, up to a hundredth of its radius: squares are divided as long as they may hold a better
// center than the best one so far.
inline Circle largest_circle(const std::vector<Point_2>& polygon)
{
  constexpr double tolerance = 0.01;
  constexpr std::size_t most_squares = 100000; // of a polygon almost without area
  struct Square
  {
    Point_2 center;
    double half, depth;
    bool operator<(const Square& other) const { return bound() < other.bound(); }
    double bound() const { return depth + half * std::sqrt(2.); } // of the depth of a point in it
  };

  const Bbox_2 box = bbox_2(polygon.begin(), polygon.end());
  const double half = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()) / 2;
  std::priority_queue<Square> squares;
  Circle best;
  const auto add = [&](double x, double y, double half_of_square)
  {
    const Square square = {Point_2(x, y), half_of_square, depth_in(polygon, Point_2(x, y))};
    if (square.depth > best.radius)
      best = {square.center, square.depth};
    squares.push(square);
  };
  add((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, half);
  for (std::size_t i = 0; i < most_squares && !squares.empty(); ++i)
  {
    const Square square = squares.top();
    if (square.bound() <= best.radius * (1 + tolerance))
      break;
    squares.pop();
    for (const int x : {-1, 1})
      for (const int y : {-1, 1})
        add(square.center.x() + x * square.half / 2, square.center.y() + y * square.half / 2,
            square.half / 2);
  }
  return best;
}

// A cap, seen along its normal.
struct Seen_cap
{
  Cap_frame frame;
  std::vector<Point_2> loop;
  Circle circle; // of radius 0 if the loop crosses itself
};

inline Seen_cap see_cap(const Loop& loop, const std::vector<Point>& points)
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Point> corners;
  for (const std::size_t v : loop)
    corners.push_back(points[v]);
  Seen_cap result = {Cap_frame(corners), {}, {}};
  if (!result.frame.is_plane())
    return result;
  CGAL::Polygon_2<Exact> polygon;
  for (const Point& corner : corners)
  {
    const Point p = result.frame.to_local(corner);
    result.loop.emplace_back(p.x(), p.y());
    polygon.push_back(Exact::Point_2(p.x(), p.y()));
  }
  if (polygon.is_simple())
    result.circle = largest_circle(result.loop);
  return result;
}

// Between the vertices of the loop and a circle around the socket, also in height.
inline std::vector<Point> points_halfway(const Loop& loop,
                                         const Seen_cap& seen,
                                         const Prism& prism,
                                         const std::vector<Point>& points)
{
  constexpr double least_distance = 0.1; // from the loop and the socket, as a share of the radius
  const double radius = prism.radius_of(prism.apothem() + prism.tolerance);
  std::vector<Point> result;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const auto outwards = seen.loop[i] - prism.center;
    const double distance = std::sqrt(outwards.squared_length());
    const Point_2 p = prism.center + (distance + radius) / (2 * distance) * outwards;
    if (distance > radius * (1 + 2 * least_distance) && depth_in(seen.loop, p) > least_distance * radius)
      result.emplace_back(p.x(), p.y(), seen.frame.to_local(points[loop[i]]).z() / 2);
  }
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal::connectors

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_SEEN_CAP_H
