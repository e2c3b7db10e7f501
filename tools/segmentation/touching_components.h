// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_TOUCHING_COMPONENTS_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_TOUCHING_COMPONENTS_H

#include "reading/Mesh.h"

#include <cstddef>

namespace tool {

struct Touching_components
{
  std::size_t touching = 0; // another one, or cut it
  std::size_t all = 0;
};

// Of a mesh with faces.
Touching_components touching_components(const Mesh& mesh);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_TOUCHING_COMPONENTS_H
