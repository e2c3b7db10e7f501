// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_BORDERS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_BORDERS_H

#include "reading/Mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tool
{

// A line along edges between two segments, as far as both stay the same.
struct Border
{
  std::array<std::size_t, 2> segments; // the one on the left comes first, and is the smaller
  std::vector<Point> points;           // of a closed line the first is not repeated
  bool is_closed = false;
  double length = 0;
};

// All borders between segments; those of the mesh are none.
std::vector<Border> find_borders(const Mesh& mesh, const std::vector<std::size_t>& segment_of_face);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_BORDERS_H
