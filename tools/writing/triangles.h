// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_TRIANGLES_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_TRIANGLES_H

#include "reading/Mesh.h"

#include <cstdint>
#include <vector>

namespace tool
{

// A fan of triangles around the first corner of the face, for formats that know triangles only. It
// is made for any face, those without area included.
template <typename Add>
void for_each_triangle(const Mesh& mesh, Face face, const Add& add)
{
  std::vector<Mesh::Vertex_index> corners;
  for (const auto v : vertices_around_face(mesh.halfedge(face), mesh))
    corners.push_back(v);
  for (std::size_t i = 2; i < corners.size(); ++i)
    add(corners[0], corners[i - 1], corners[i]);
}

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_TRIANGLES_H
