// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPAIR_INPUT_MESH_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPAIR_INPUT_MESH_H

#include "reading/Mesh.h"
#include "reading/Polygon_soup.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tool
{

// What had to be done so that the faces of a file make up a surface.
struct Repairs
{
  std::size_t degenerate_faces = 0;   // with fewer than three different corners: left out
  std::size_t duplicate_faces = 0;    // with the corners of another one, turned over or not: left out
  std::size_t non_manifold_edges = 0; // of more than two faces, without duplicates
  std::size_t reversed_faces = 0;
  std::size_t specks = 0;     // small components or inner walls that touch the rest: left out
  std::size_t components = 0; // connected ones, of what is segmented
};

// The faces of a file, and the mesh that is segmented in their place. They are the same unless something had to
// be repaired.
struct Input_mesh
{
  Polygon_soup soup;
  Mesh mesh;
  std::vector<std::size_t> label_giver;  // of each face of the file: the face of the mesh that has its label
  std::vector<std::size_t> face_in_file; // of each face of the mesh
  std::vector<std::size_t> point_of_vertex; // of each vertex of the mesh: its point in the soup
  Repairs repairs;
};

// Throws a `Format_error` if all faces are degenerate.
Input_mesh make_input_mesh(Polygon_soup soup);

// A value for each face of the file from a value for each face of the mesh.
template <typename T>
std::vector<T> spread(const std::vector<T>& of_mesh, const Input_mesh& input)
{
  std::vector<T> of_file;
  of_file.reserve(input.label_giver.size());
  for (const std::size_t face : input.label_giver)
    of_file.push_back(of_mesh[face]);
  return of_file;
}

// In one line; empty if there was nothing to do.
std::string describe(const Repairs& repairs);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_REPAIR_INPUT_MESH_H
