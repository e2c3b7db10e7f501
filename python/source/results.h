// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_RESULTS_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_RESULTS_H

#include "parts.h"
#include "segment.h"
#include "smooth.h"

#include <CGAL/Protrusion_segmentation/Segmentation_metrics.h>

#include <pybind11/pybind11.h>

#include <vector>

namespace python {

// What C++ found as arrays of numpy, by the names of the fields in _results.py.
pybind11::dict as_dict(const Segmentation& segmentation);
pybind11::dict as_dict(const Smoothed& smoothed);
pybind11::dict as_python(const std::vector<Joint>& joints);
pybind11::list as_python(const std::vector<Part>& parts);
pybind11::tuple as_python(const Connected_parts& parts);
pybind11::list as_list(const std::vector<CGAL::Protrusion_segmentation::Segmentation_metrics>& metrics);

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_RESULTS_H
