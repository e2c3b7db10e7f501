// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_GLTF_PRIMITIVES_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_GLTF_PRIMITIVES_H

#include "writing/Gltf_document.h"
#include "writing/formats.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tool {

// How coordinates of the mesh become numbers in single precision: as they are, unless that would lose much of them. Then a root
// node has what puts them where they are in the mesh.
class Gltf_frame
{
public:
  Gltf_frame(const std::vector<Point>& points, const std::string& up);

  std::array<float, 3> position(const Point& point) const;

  // The nodes, or what they hang on if it is needed: turned so that what is up in the mesh is up in glTF.
  std::vector<std::size_t> add_root(const std::vector<std::size_t>& nodes, Gltf_document& document) const;

private:
  std::array<double, 3> m_center = {0, 0, 0};
  double m_scale = 1;
  bool m_is_turned;
};

// The triangles of a segment with one material.
struct Segment_primitive
{
  std::size_t segment;
  std::string name;
  Gltf_document::Json primitive;
};

// Adds attributes for the vertices of a segment, whose points it is told.
using Add_attributes = std::function<void(const std::vector<std::size_t>& points, Gltf_document::Json& attributes)>;

// Of all segments that have triangles, one for each material of the input if that is asked for. Those of a segment follow each
// other.
std::vector<Segment_primitive> add_primitives(const Output& output,
                                              const Gltf_frame& frame,
                                              Gltf_document& document,
                                              const Add_attributes& add_attributes = {});

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_GLTF_PRIMITIVES_H
