// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the targets for mesh files share: all the way of the command line tool, from the bytes of a file to a mesh that
// has a label for each face, or to an error in one line; then to a valid segmentation.

#ifndef CGAL_TEST_PROTRUSION_SEGMENTATION_FUZZ_MESH_FILE_H
#define CGAL_TEST_PROTRUSION_SEGMENTATION_FUZZ_MESH_FILE_H

#include <cstddef>
#include <string>

// `choice` stands for the method and the number of segments.
void fuzz_mesh_file(const std::string& extension, const std::string& bytes, std::size_t choice);

#endif // CGAL_TEST_PROTRUSION_SEGMENTATION_FUZZ_MESH_FILE_H
