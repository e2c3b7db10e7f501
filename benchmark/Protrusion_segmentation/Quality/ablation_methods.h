// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The default method without one of its ingredients at a time, and on other meshes of the same shape.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_ABLATION_METHODS_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_ABLATION_METHODS_H

#include "Segmentation_method.h"

#include <vector>

// "Without-widening" and so on.
std::vector<Segmentation_method> ablation_methods();

// "Remeshed-half", "Remeshed-double", "Remeshed-anisotropic": the mesh is remeshed to half or twice as many
// faces, or to triangles three times as long in one direction as across; the segments of the new mesh go to
// the nearest faces of the old one, which are scored.
std::vector<Segmentation_method> remeshed_methods();

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_ABLATION_METHODS_H
