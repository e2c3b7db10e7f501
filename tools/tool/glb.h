// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_GLB_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_GLB_H

#include "../include/read_mesh.h"

#include <cstdint>
#include <ostream>

namespace tool
{

// Writes binary glTF 2.0: a node "segment N" for each segment, with a mesh and a material of its own, so
// that segments can be picked one by one in other programs. Coordinates are as in the mesh.
void write_GLB(std::ostream& out,
               const Mesh& mesh,
               const Mesh::Property_map<Face, std::uint32_t>& segments);

} // namespace tool

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_GLB_H
