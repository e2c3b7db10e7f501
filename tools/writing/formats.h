// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A writer for each format.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_FORMATS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_FORMATS_H

#include "writing/Format_options.h"
#include "writing/Segmented_soup.h"

#include <ostream>
#include <string>
#include <vector>

namespace tool {

// A file with what is to be in it.
struct Output
{
  const Segmented_soup& surface;
  const Format_options& options;
  std::string companion; // the name of the file beside it; empty: there is none
  std::string folder;    // that the file is in
};

void write_SEG(std::ostream& out, const Output& output);

// Version 1.0 of numpy's format: a vector of integers of 32 bits.
void write_NPY(std::ostream& out, const Output& output);

void write_OFF(std::ostream& out, const Output& output);

// The faces segment by segment, each a group with a material of the companion, or of the input's; with what the input has at
// corners.
void write_OBJ(std::ostream& out, const Output& output);
void write_MTL(std::ostream& out, const Output& output);

// Binary. For readers that skip unknown data of faces, vertices have a segment and a colour, too: those of one of their faces.
void write_PLY(std::ostream& out, const Output& output);

// Binary, without segments, for which the format has no place.
void write_STL(std::ostream& out, const Output& output);

// Polygonal data of VTK as XML text.
void write_VTP(std::ostream& out, const Output& output);

// glTF 2.0, binary or as text. Coordinates are those of the mesh, in single precision. Normals are smooth but at creases.
void write_GLB(std::ostream& out, const Output& output);
void write_GLTF(std::ostream& out, const Output& output);

// Universal Scene Description as text: a mesh with a partition into subsets, one for each segment, with its material.
void write_USDA(std::ostream& out, const Output& output);

// One mesh: its segments are triangle sets, materials, and what painting is in slicers.
void write_3MF(std::ostream& out, const Output& output);

// One object that is made of a mesh for each part.
void write_parts_in_3MF(std::ostream& out, const std::vector<Segmented_soup>& parts);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_FORMATS_H
