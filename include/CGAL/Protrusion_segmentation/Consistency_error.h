// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_CONSISTENCY_ERROR_H
#define CGAL_PROTRUSION_SEGMENTATION_CONSISTENCY_ERROR_H

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationMetrics

The result of `segmentation_consistency_error()`: means over the faces, each in [0, 1), 0 if
default-constructed. Smaller is better.
*/
struct Consistency_error
{
  /// refinement allowed in one direction, parts of segments measured by their number of faces
  double global = 0;
  /// refinement allowed in either direction at each face, measured by number of faces; at most `global`
  double local = 0;
  /// refinement allowed in one direction, parts of segments measured by area
  double global_by_area = 0;
  /// refinement allowed in either direction at each face, measured by area; at most `global_by_area`
  double local_by_area = 0;
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_CONSISTENCY_ERROR_H
