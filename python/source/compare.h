// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_COMPARE_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_COMPARE_H

#include "mesh_of_arrays.h"

#include <CGAL/Protrusion_segmentation/Segmentation_metrics.h>

#include <cstdint>
#include <string>
#include <vector>

namespace python {

// The metrics of labels against each of the references, all of the faces given; only those that are asked for: "all",
// "rand_index_error", "hamming_distance", "cut_discrepancy", "consistency_error" or "mean_best_intersection_over_union".
std::vector<CGAL::Protrusion_segmentation::Segmentation_metrics> compare(
  const Arrays& arrays,
  const std::vector<std::int64_t>& labels,
  const std::vector<std::vector<std::int64_t>>& references,
  const std::string& metrics);

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_COMPARE_H
