// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CUT_EACH_OTHER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CUT_EACH_OTHER_H

#include <CGAL/Protrusion_segmentation/internal/Closing/Capper.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Cap_frame.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::connectors {

// Do two triangles meet elsewhere than in the vertices and the edge that they share? The vertices are numbers of points.
inline bool cut_each_other(Triangle s, Triangle t, const std::vector<Point>& points)
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto shared_first = [](Triangle& triangle, const Triangle& other)
  {
    return std::size_t(std::partition(triangle.begin(), triangle.end(),
                                      [&](std::size_t v) {
                                        return std::find(other.begin(), other.end(), v) != other.end();
                                      }) -
                       triangle.begin());
  };
  const std::size_t number_of_shared = shared_first(s, t);
  shared_first(t, s);
  const auto point = [&](std::size_t v)
  { return Exact::Point_3(points[v].x(), points[v].y(), points[v].z()); };
  const Exact::Point_3 a = point(s[0]), b = point(s[1]), c = point(s[2]), d = point(t[0]),
                       e = point(t[1]), f = point(t[2]);
  const Exact::Triangle_3 first(a, b, c), second(d, e, f);
  if (first.is_degenerate() || second.is_degenerate())
    return number_of_shared < 2;
  if (number_of_shared == 0)
    return CGAL::do_intersect(first, second);
  if (number_of_shared == 1)
    return CGAL::do_intersect(Exact::Segment_3(b, c), second) ||
           CGAL::do_intersect(Exact::Segment_3(e, f), first);
  return number_of_shared == 3 || (CGAL::orientation(a, b, c, f) == CGAL::COPLANAR &&
                                   CGAL::coplanar_orientation(a, b, c, f) == CGAL::POSITIVE);
}

} // namespace CGAL::Protrusion_segmentation::internal::connectors

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CUT_EACH_OTHER_H
