// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fewer triangles for the same surface, for peers whose time grows fast with the number of faces.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_DECIMATION_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_DECIMATION_H

#include "Segmentation_method.h"

#include <cstddef>

// At most about `number_of_faces`, as far as edges can be collapsed; a mesh that has no more is returned as it is.
Mesh decimated(const Mesh& mesh, std::size_t number_of_faces);

// For every face of `mesh`, the label of the face of `decimated` that is nearest to its centre.
Labels labels_from_decimated(const Mesh& mesh, const Mesh& decimated, const Labels& labels);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_DECIMATION_H
