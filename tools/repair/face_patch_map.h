// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPAIR_FACE_PATCH_MAP_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPAIR_FACE_PATCH_MAP_H

#include "reading/Mesh.h"

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <vector>

namespace tool
{

// What `patches_of_mesh()` returned as the map of a named parameter. With no patches, each face is of the patch 0.
inline auto face_patch_map(const std::vector<std::size_t>& patches)
{
  return boost::make_function_property_map<Face>([&patches](Face face)
                                                 { return patches.empty() ? std::size_t(0) : patches[face]; });
}

} // namespace tool

#endif
