// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"

#if __has_include("reading/read_mesh.h") // of the tools
#include "reading/read_mesh.h"

#include <CGAL/boost/graph/copy_face_graph.h>
#else
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>

#include <stdexcept>
#endif

#if __has_include("reading/read_mesh.h")

Mesh_of_file read_mesh(const std::string& file_name)
{
  const tool::Input_mesh input = tool::read_input_mesh(file_name);
  Mesh_of_file result;
  CGAL::copy_face_graph(input.mesh, result.mesh); // into that of another kernel
  result.faces = File_faces({input.face_in_file.begin(), input.face_in_file.end()},
                            {input.label_giver.begin(), input.label_giver.end()});
  return result;
}

#else

Mesh_of_file read_mesh(const std::string& file_name)
{
  Mesh_of_file result;
  if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file_name, result.mesh))
    throw std::runtime_error(file_name + ": no mesh that can be read");
  if (result.mesh.number_of_faces() == 0)
    throw std::runtime_error(file_name + ": has no faces");
  result.mesh.collect_garbage();
  result.faces = File_faces(result.mesh.number_of_faces());
  return result;
}

#endif
