// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COLLECTION_LIST_MESHES_H
#define PROTRUSION_SEGMENTATION_TOOLS_COLLECTION_LIST_MESHES_H

#include <string>
#include <vector>

namespace tool
{

struct Mesh_in_collection
{
  std::string input;
  std::string name; // of its outputs, but for the extension: a path relative to the output folder
};

// All that is named, and of folders all files in them, at any depth, that have the extension of a mesh; in
// the order of their names. What is in a folder keeps its place there. Meshes whose names differ by their
// extension keep it. What is in the output folder is no mesh unless it is itself named. Throws an `Error` if a
// folder cannot be read, or two meshes have the same name.
std::vector<Mesh_in_collection> list_meshes(const std::vector<std::string>& inputs,
                                            const std::string& output_folder);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COLLECTION_LIST_MESHES_H
