// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: what follows maximum_number_of_segments must be a method

#include "mesh.h"

std::size_t segment(const Mesh& mesh)
{
  return CGAL::protrusion_hierarchy(mesh, 5, Landmark_geodesic_distance(0.1)).maximum_number_of_segments();
}
