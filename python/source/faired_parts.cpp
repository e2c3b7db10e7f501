// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parts.h"

#include <CGAL/Protrusion_segmentation/faired_closed_segments.h>

#include <iterator>

namespace python {

std::vector<Part> close_segments_by_faired_caps(const Arrays& arrays, const Tree_of_arrays& tree)
{
  const Segmented_mesh mesh = segmented_mesh(arrays, tree);
  std::vector<Part> parts;
  CGAL::Protrusion_segmentation::faired_closed_segments(mesh.input.mesh, mesh.segments(), mesh.record,
                                                        std::back_inserter(parts));
  return parts;
}

} // namespace python
