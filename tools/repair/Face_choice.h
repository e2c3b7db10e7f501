// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPAIR_FACE_CHOICE_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPAIR_FACE_CHOICE_H

#include "reading/Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace tool
{

// Points that lie on each other are at one place, which is named by the first of them.
std::vector<std::size_t> places(const std::vector<Point>& points);

// The faces that go into the mesh, and who labels those that do not.
struct Face_choice
{
  std::vector<std::size_t> kept;        // in their order
  std::vector<std::size_t> label_giver; // of each face of the file: a position in `kept`
  std::vector<Polygon> polygons;        // of the kept faces, without corners twice in a row
  std::vector<bool> has_double;         // for each kept face: is there another one with the same corners?
  std::size_t degenerate_faces = 0;
  std::size_t duplicate_faces = 0;
};

// Of faces with the same corners the first one is kept and labels the others. A face that has fewer than three corners
// is labelled by a neighbour: a face that shares an edge with it, or a corner, or else the one before it in the file. So
// is a face with `is_left_out`.
Face_choice choose_faces(const Polygon_soup& soup,
                         const std::vector<std::size_t>& places,
                         const std::vector<bool>& is_left_out);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_REPAIR_FACE_CHOICE_H
