// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// expected: what follows tips must be a distance

#include "mesh.h"

std::size_t select(const Mesh& mesh)
{
  std::vector<Mesh::Face_index> tips;
  CGAL::protrusion_tips(mesh, 5, std::back_inserter(tips), Histogram_method());
  return tips.size();
}
