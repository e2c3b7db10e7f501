// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/write_mesh.h"

#include "command_line/Error.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

namespace tool
{

void write_mesh(const std::string& file_name, const Mesh& mesh)
{
  if (!CGAL::IO::write_polygon_mesh(file_name, mesh, CGAL::parameters::stream_precision(9)))
    throw Error(file_name, "cannot be written");
}

} // namespace tool
