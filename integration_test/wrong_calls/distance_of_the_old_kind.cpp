// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: the distance is no model of ProtrusionDistance

#include "mesh.h"

// It is prepared with a seed where it should be with an execution.
struct Distance
{
  Geodesic_distance::On_surface on(const Indexed_surface& surface, unsigned int random_seed) const;
};

std::size_t segment(const Mesh& mesh, Segment_map ids)
{
  return CGAL::segmentation_via_protrusion_tips(mesh, ids, 5, Minimum_cut_method(Distance()));
}
