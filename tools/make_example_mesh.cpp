// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a mesh to try a segmentation on:
//
//   make_example_mesh octopus|teddy|hand|horse|chair FILE [--faces N]
//
// The same arguments give the same mesh.

#include "command_line/Error.h"
#include "command_line/Help_formatter.h"
#include "command_line/integer_option.h"
#include "command_line/tool_main.h"
#include "example_meshes/mesh_of_shape.h"
#include "example_meshes/shapes.h"
#include "writing/write_mesh.h"
#include "writing/write_output.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <iostream>
#include <string>

int main(int argc, char** argv)
{
  const auto& shapes = example_shapes::shapes();
  std::string name, file;
  std::size_t faces = 24000;
  CLI::App app("Makes a mesh to try a segmentation on.", "make_example_mesh");
  app.add_option("SHAPE", name, "octopus, teddy, hand, horse or chair")
      ->required()
      ->check(CLI::IsMember(shapes).description(""))
      ->type_name("");
  app.add_option("FILE", file, "the file to write: .off, .ply, .obj or .stl")
      ->required()
      ->check([](const std::string& name)
              { return tool::can_write_mesh(name) ? "" : name + " cannot be written: only .off, .ply, .obj and .stl are known"; })
      ->type_name("");
  app.add_option("--faces", faces, "least number of faces, from 1000 to 1000000; there are up to a quarter more")
      ->transform(tool::integer("number of faces", 1000, 1000000))
      ->type_name("N")
      ->capture_default_str()
      ->group("Options");
  tool::complete_help(app, "[OPTION...] SHAPE FILE", "Operands",
                      {{"make_example_mesh octopus octopus.off", "an octopus of some 24000 faces"}});
  return tool::main(app, argc, argv, [&]() {
    const tool::Mesh mesh = example_shapes::mesh_of_shape(shapes.at(name)(), faces);
    tool::write_mesh(file, mesh);
    std::cout << file << ": " << name << ", " << mesh.number_of_faces() << " faces\n";
    tool::finish_standard_output();
  });
}
