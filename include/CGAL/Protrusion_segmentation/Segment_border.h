// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SEGMENT_BORDER_H
#define CGAL_PROTRUSION_SEGMENTATION_SEGMENT_BORDER_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

A line of edges between two segments, as long as both stay the same: a closed one, or one that ends where three segments
meet or at the boundary of the mesh.

\tparam Point the type of the points of the mesh
*/
template <typename Point>
struct Segment_border
{
  std::array<std::size_t, 2> segments; ///< the smaller id first; that segment is on the left, seen from outside
  std::vector<Point> points;           ///< the points of the vertices; of a closed line the first is not repeated
  bool is_closed = false;              ///< whether the first point follows the last
  double length = 0;                   ///< the sum of the lengths of the edges, in the unit of the mesh
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_SEGMENT_BORDER_H
