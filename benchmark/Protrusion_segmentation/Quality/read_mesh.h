// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_READ_MESH_H
#define CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_READ_MESH_H

#include "File_faces.h"
#include "Segmentation_method.h"

#include <string>

struct Mesh_of_file
{
  Mesh mesh;
  File_faces faces;
};

// Reads as the command line tool does, or by CGAL's reader where this folder is built without the tools. Throws
// `std::runtime_error`, which names the file and the cause.
Mesh_of_file read_mesh(const std::string& file_name);

#endif // CGAL_PROTRUSION_SEGMENTATION_BENCHMARK_READ_MESH_H
