// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mesh type of all tools. None of CGAL's readers comes with it: they are compiled once, in read_mesh.cpp.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_READING_MESH_H
#define PROTRUSION_SEGMENTATION_TOOLS_READING_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace tool
{

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = Mesh::Face_index;

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_READING_MESH_H
