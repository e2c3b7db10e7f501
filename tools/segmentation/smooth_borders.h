// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SMOOTH_BORDERS_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SMOOTH_BORDERS_H

#include "reading/Mesh.h"

#include <cstddef>
#include <vector>

namespace tool
{

// A mesh whose faces were cut along smooth borders.
struct Smoothed_mesh
{
  Mesh mesh;
  std::vector<std::size_t> segment_ids; // of its faces
  std::vector<std::size_t> old_faces;   // of its faces: what each is a piece of
  std::size_t number_of_fixed_segments = 0; // that are too thin
};

Smoothed_mesh smooth_borders(const Mesh& mesh, const std::vector<std::size_t>& segment_ids);

// For each old face the segment that has the largest part of it. A segment that has the largest part of none gets the face
// of which it has most.
std::vector<std::size_t> segments_of_old_faces(const Smoothed_mesh& smoothed,
                                               std::size_t number_of_old_faces,
                                               std::size_t number_of_segments);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_SMOOTH_BORDERS_H
