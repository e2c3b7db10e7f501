// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_METRICS_H
#define CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_METRICS_H

#include <CGAL/Protrusion_segmentation/Consistency_error.h>
#include <CGAL/Protrusion_segmentation/Hamming_distance.h>

#include <optional>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationMetrics

The result of `segmentation_metrics()`: all metrics of a segmentation against a reference. Smaller is
better in each of them but the last one.
*/
struct Segmentation_metrics
{
  /// see `segmentation_rand_index_error()`; in [0, 1], default 0
  double rand_index_error = 0;
  /// see `segmentation_hamming_distance()`
  Hamming_distance hamming_distance;
  /// see `segmentation_cut_discrepancy()`; in average radii and not negative, or without a value where it
  /// is undefined, as by default
  std::optional<double> cut_discrepancy;
  /// see `segmentation_consistency_error()`
  Consistency_error consistency_error;
  /// see `mean_best_intersection_over_union()`; in (0, 1], default 1
  double mean_best_intersection_over_union = 1;
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_METRICS_H
