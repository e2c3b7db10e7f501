// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_CLOSED_SEGMENT_H
#define CGAL_PROTRUSION_SEGMENTATION_CLOSED_SEGMENT_H

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

A segment as a surface of its own: its faces, in their order in the mesh, and behind them the triangles that close it where it
was cut off.

\tparam Point the type of the points of the mesh
*/
template <typename Point>
struct Closed_segment
{
  std::vector<Point> points;                      ///< those that it needs
  std::vector<std::vector<std::size_t>> polygons; ///< the corners of each face, as indices of points
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_CLOSED_SEGMENT_H
