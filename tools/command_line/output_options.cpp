// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/output_options.h"

#include "report/report.h"
#include "writing/outputs.h"

#include <CLI/CLI.hpp>

#include <string>

namespace tool {
namespace {

void add_options_of_meshes(CLI::App& app, Command_line& command_line, const char* group)
{
  std::string outputs =
    "write the segments; may be repeated. With %d, %03d or %s in the name, a mesh is written for each "
    "segment, by its number or its name, in a folder that is made if needed. - is the standard output, "
    "in SEG. The extension "
    "tells the format:";
  for (const std::string& format : output_formats())
    outputs += "\n" + format;
  app.add_option("-o,--output", command_line.outputs, outputs)
    ->allow_extra_args(false)
    ->type_name("FILE")
    ->group(group);
  app
    .add_flag("--close{flat}", command_line.caps,
              "close the meshes of -o with %d or %s, of -o FILE.3mf, or of --format, where they were cut "
              "off. If the input is closed, so are they.\n"
              "flat: caps that two meshes share; volumes add up to that of the input (the default)\n"
              "faired: rounded caps, separate for each mesh; slow for long rims\n"
              "hull: the convex hull of each segment in its place, for simulation")
    ->check(CLI::IsMember({"flat", "faired", "hull"}).description(""))
    ->option_text("[=CAPS]")
    ->group(group);
  app
    .add_flag("--smooth-borders", command_line.options.are_borders_smooth,
              "cut faces along smooth borders. Meshes then have more faces, each with the number of its "
              "old face; "
              "SEG has the segment of the largest piece of each old face.")
    ->group(group);
}

void add_options_of_formats(CLI::App& app, Format_options& options, const char* group)
{
  app
    .add_flag(
      "--triangulate", options.are_faces_triangulated,
      "write faces of more than three corners as triangles, as slicers need them in OBJ. Each triangle "
      "has the number of its old face where the format has a place.")
    ->group(group);
  app
    .add_flag(
      "--one-object", options.is_one_object,
      "in glTF, write one object with a material for each segment, in place of an object for each")
    ->group(group);
  app
    .add_option_function<std::string>(
      "--colors", [&](const std::string& choice) { options.are_colors_of_input = choice == "input"; },
      "segments: colours and materials are those of segments (the default)\n"
      "input: they are those of the input where it has some: vertex colours in PLY, OBJ and glTF, "
      "materials in OBJ and glTF, with their pictures in the latter. Texture coordinates and normals stay in any case.")
    ->check(CLI::IsMember({"segments", "input"}).description(""))
    ->type_name("NAME")
    ->group(group);
  app
    .add_option("--up", options.up, "axis of the mesh that points up, for glTF and USD; coordinates stay")
    ->check(CLI::IsMember({"y", "z"}).description(""))
    ->type_name("y|z")
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--array-name", options.array_name, "name of the array of segments in VTP, such as Label")
    ->type_name("NAME")
    ->capture_default_str()
    ->group(group);
}

} // namespace

void add_output_options(CLI::App& app, Command_line& command_line)
{
  const char* group = "Output";
  add_options_of_meshes(app, command_line, group);
  add_options_of_formats(app, command_line.options.formats, group);
  app
    .add_option(
      "--borders", command_line.borders,
      "write the borders as lines of VTK (.vtp), with both segments, length, value and probability")
    ->type_name("FILE")
    ->group(group);
  app
    .add_option(
      "--skeleton", command_line.skeleton,
      "write a curve skeleton as lines of VTK (.vtp), from tips, borders and the tree of segments")
    ->type_name("FILE")
    ->group(group);
  app
    .add_option(
      "--rig", command_line.rig,
      "write the mesh with a joint for each segment, which moves it with all that sticks out of it, in "
      "glTF (.glb, .gltf)")
    ->type_name("FILE")
    ->group(group);
  app
    .add_option("--json", command_line.json, "write all that was found as JSON; - is the standard output")
    ->type_name("FILE")
    ->group(group);
  app
    .add_option(
      "--report", command_line.report,
      std::string("write a page for the browser: the mesh in 3D, and what is known of each segment") +
        (can_write_report() ? "" : "\nNot available: three.js was not found at build time."))
    ->type_name("FILE")
    ->group(group);
  app
    .add_flag("--quiet", command_line.is_quiet,
              "print nothing but errors, and a warning if there are fewer segments than asked for")
    ->group(group);
}

} // namespace tool
