// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_MATERIALS_OF_MTL_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_MATERIALS_OF_MTL_H

#include "reading/Surface_attributes.h"

#include <memory>

namespace tool {

// The materials that faces of an OBJ file name, as those of glTF: colours, opacity and pictures of colours, where the
// material files can be read. None if there are no such files.
std::shared_ptr<const Gltf_materials> materials_of_MTL(const Surface_attributes& attributes);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_MATERIALS_OF_MTL_H
