// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_MESH_OF_ARRAYS_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_MESH_OF_ARRAYS_H

#include "repair/Input_mesh.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace python {

// A mesh as arrays.
struct Arrays
{
  std::vector<double> coordinates;          // x, y and z of each vertex
  std::vector<std::int64_t> corners;        // of all faces, one after the other, as numbers of vertices
  std::vector<std::int64_t> sizes;          // the number of corners of each face
  std::optional<double> snapping_tolerance; // up to which corners on borders are one
  bool are_pieces_joined = false;
  std::optional<double> gap; // up to which pieces are joined
};

// The surface that the faces make up, repaired as the command line tools do. Throws std::invalid_argument if an array
// makes no sense.
tool::Input_mesh mesh_of_arrays(const Arrays& arrays);

// The labels of the faces of the mesh from those of the faces given. Throws std::invalid_argument, with the name of the argument,
// if these are not as many as there are faces.
std::vector<std::int64_t> labels_of_mesh(const std::vector<std::int64_t>& labels,
                                         const tool::Input_mesh& input,
                                         const std::string& name);

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_MESH_OF_ARRAYS_H
