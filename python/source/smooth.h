// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_SMOOTH_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_SMOOTH_H

#include "mesh_of_arrays.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace python {

// A mesh whose faces were cut along smooth borders.
struct Smoothed
{
  std::vector<double> coordinates;
  std::vector<std::int64_t> corners, sizes;
  std::vector<std::int64_t> labels, old_faces; // of the new faces; old faces are those that were given
  std::size_t number_of_fixed_segments = 0;
};

Smoothed smooth(const Arrays& arrays,
                const std::vector<std::int64_t>& labels,
                unsigned int number_of_iterations);

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_SMOOTH_H
