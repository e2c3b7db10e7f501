// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_READ_LABELS_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_READ_LABELS_H

#include "repair/Input_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tool {

// The labels of the faces of the mesh, from a file with a label for each face of the mesh's file: .seg, .npy, or face data
// "segment" or "label" of a PLY or VTP file. Throws an `Error`.
std::vector<std::size_t> read_labels(const std::string& file_name, Input_mesh& input);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_READ_LABELS_H
