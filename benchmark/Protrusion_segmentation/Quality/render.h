// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small pictures of segmented meshes: parallel projection, flat shading, one colour a segment.

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RENDER_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RENDER_H

#include "Segmentation_method.h"

#include <cstdint>
#include <vector>

// Seen from the side that shows most of the mesh: across its two longest principal axes, a little
// turned. Returns a PNG file.
std::vector<std::uint8_t> render(const Mesh& mesh, const Labels& colors);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_RENDER_H
