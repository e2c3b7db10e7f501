// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Other triangles of the same surface.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_OTHER_TRIANGLES_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_OTHER_TRIANGLES_H

#include "Segmentation_method.h"

#include <vector>

// The mesh remeshed to about `density` times as many faces, about `anisotropy` times as long in one direction as across.
Mesh remeshed(Mesh mesh, double density, double anisotropy);

// For every face of `mesh`, the face of `other` nearest to its centre.
std::vector<Face> nearest_faces(const Mesh& mesh, const Mesh& other);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_OTHER_TRIANGLES_H
