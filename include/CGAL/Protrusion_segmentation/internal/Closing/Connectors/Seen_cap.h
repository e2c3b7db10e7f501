// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_SEEN_CAP_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_SEEN_CAP_H

#include <CGAL/Protrusion_segmentation/internal/Closing/Capper.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Cap_frame.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Prism.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/largest_circle.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::connectors {

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
