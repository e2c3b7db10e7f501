// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPAIR_INPUT_MESH_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPAIR_INPUT_MESH_H

#include "reading/Mesh.h"
#include "reading/Polygon_soup.h"

#include <CGAL/Protrusion_segmentation/Polygon_soup_repairs.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tool
{

using Repairs = CGAL::Protrusion_segmentation::Polygon_soup_repairs;

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
  std::size_t inside_out_components = 0; // whose faces are turned over in the mesh
};

// By the package's `polygon_soup_to_manifold_mesh()`, with its tolerance if none is given. Throws a `Format_error` if all faces
// are degenerate.
Input_mesh make_input_mesh(Polygon_soup soup, std::optional<double> tolerance = std::nullopt);

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
std::string describe_repairs(const Input_mesh& input);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_REPAIR_INPUT_MESH_H
