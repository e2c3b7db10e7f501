// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPAIR_INPUT_MESH_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPAIR_INPUT_MESH_H

#include "reading/Mesh.h"
#include "reading/Polygon_soup.h"

#include <CGAL/Protrusion_segmentation/Polygon_soup_repairs.h>

#include <cstddef>
#include <cstdint>
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
  std::vector<std::uint32_t> label_giver;  // of each face of the file: the face of the mesh that has its label
  std::vector<std::uint32_t> face_in_file; // of each face of the mesh
  std::vector<std::size_t> point_of_vertex; // of each vertex of the mesh: its point in the soup
  Repairs repairs;
  std::size_t inside_out_components = 0; // whose faces are turned over in the mesh
  // If loose pieces are joined, of each face of the file. The mesh is a surface around them then, and its faces and vertices
  // have those of the file that are nearest.
  std::vector<std::size_t> pieces;
  std::vector<double> areas;

  bool has_joined_pieces() const { return !pieces.empty(); }
};

// By the package's `polygon_soup_to_manifold_mesh()`, with its tolerance if none is given. Throws a `Format_error` if all faces
// are degenerate.
Input_mesh make_input_mesh(Polygon_soup soup, std::optional<double> tolerance = std::nullopt);

// One surface around pieces that are nearer to each other than the gap, or than that of the package's `join_pieces()`. Throws a
// `Format_error` if no face has an area, and `std::invalid_argument` if the gap is out of range.
Input_mesh join_pieces(Polygon_soup soup, std::optional<double> gap);

// The labels of the faces of the file from those of the faces of the mesh.
std::vector<std::size_t> labels_of_file(const std::vector<std::size_t>& labels_of_mesh, const Input_mesh& input);

// Of every face of the mesh: the piece that it is nearest to if loose pieces are joined, else none.
std::vector<std::size_t> patches_of_mesh(const Input_mesh& input);

// In one line; empty if there was nothing to do.
std::string describe_repairs(const Input_mesh& input);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_REPAIR_INPUT_MESH_H
