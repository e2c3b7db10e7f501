// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_READ_LABELS_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_READ_LABELS_H

#include "repair/Input_mesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tool {

// The labels of the faces of the mesh, from a file with a label for each face of the mesh's file: .seg, .npy, JSON as an array or
// an object with the numbers of the faces, or face data "segment" or "label" of a PLY or VTP file. Throws an `Error`.
std::vector<std::size_t> read_labels(const std::string& file_name, Input_mesh& input);

// The same, where faces may have none: then the label is negative. A name that tells of no format is that of a .seg file.
std::vector<std::int64_t> read_some_labels(const std::string& file_name, Input_mesh& input);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_READ_LABELS_H
