// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/write_mesh.h"

#include "reading/lower_case_extension.h"
#include "writing/write_output.h"

#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <map>
#include <ostream>
#include <string>

namespace tool
{

namespace
{

using Writer = void (*)(std::ostream&, const Mesh&);

constexpr int number_of_digits = 9;

const std::map<std::string, Writer>& writers()
{
  static const std::map<std::string, Writer> result = {
      {".off", [](std::ostream& out, const Mesh& mesh)
       { CGAL::IO::write_OFF(out, mesh, CGAL::parameters::stream_precision(number_of_digits)); }},
      {".obj", [](std::ostream& out, const Mesh& mesh)
       { CGAL::IO::write_OBJ(out, mesh, CGAL::parameters::stream_precision(number_of_digits)); }},
      {".ply", [](std::ostream& out, const Mesh& mesh)
       {
         CGAL::IO::set_binary_mode(out);
         CGAL::IO::write_PLY(out, mesh);
       }},
      {".stl", [](std::ostream& out, const Mesh& mesh)
       {
         CGAL::IO::set_binary_mode(out);
         CGAL::IO::write_STL(out, mesh);
       }}};
  return result;
}

} // namespace

bool can_write_mesh(const std::string& file_name)
{
  return writers().count(lower_case_extension(file_name)) > 0;
}

void write_mesh(const std::string& file_name, const Mesh& mesh)
{
  const Writer write = writers().at(lower_case_extension(file_name));
  write_output(file_name, [&](std::ostream& out) { write(out, mesh); });
}

} // namespace tool
