// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_HAMMING_DISTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_HAMMING_DISTANCE_H

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationMetrics

The result of `segmentation_hamming_distance()`: fractions of the area of the mesh, each in [0, 1), 0 if
default-constructed. Smaller is better.
*/
struct Hamming_distance
{
  /// the mean of the two rates
  double distance = 0;
  /// the area of the reference's segments outside their best match in the segmentation
  double missing_rate = 0;
  /// the area of the segmentation's segments outside their best match in the reference
  double false_alarm_rate = 0;
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_HAMMING_DISTANCE_H
