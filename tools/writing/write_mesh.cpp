// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/write_mesh.h"

#include "command_line/Error.h"
#include "reading/lower_case_extension.h"
#include "writing/write_output.h"

#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <functional>
#include <map>
#include <ostream>

namespace tool
{

void write_mesh(const std::string& file_name, const Mesh& mesh)
{
  const auto precision = CGAL::parameters::stream_precision(9);
  const std::map<std::string, std::function<void(std::ostream&)>> writers = {
      {".off", [&](std::ostream& out) { CGAL::IO::write_OFF(out, mesh, precision); }},
      {".obj", [&](std::ostream& out) { CGAL::IO::write_OBJ(out, mesh, precision); }},
      {".ply",
       [&](std::ostream& out) {
         CGAL::IO::set_binary_mode(out);
         CGAL::IO::write_PLY(out, mesh, precision);
       }},
      {".stl", [&](std::ostream& out) {
         CGAL::IO::set_binary_mode(out);
         CGAL::IO::write_STL(out, mesh, precision);
       }}};
  const auto writer = writers.find(lower_case_extension(file_name));
  if (writer == writers.end())
    throw Error(file_name, "cannot be written: only .off, .ply, .obj and .stl are known");
  write_output(file_name, writer->second);
}

} // namespace tool
