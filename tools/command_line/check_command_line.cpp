// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/check_command_line.h"

#include "command_line/segment_options.h"
#include "reading/lower_case_extension.h"
#include "report/report.h"
#include "segmentation/segment.h"
#include "writing/outputs.h"
#include "writing/part_names.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace tool {
namespace {

// Options of a distance or a method that was not chosen would be ignored in silence.
void check_meanings(const CLI::App& app, const std::vector<Choice>& choices, const std::string& chosen)
{
  for (const Choice& choice : choices)
    for (const std::string& option : choice.options)
      if (choice.name != chosen && app.count(option) > 0)
        throw std::invalid_argument(option + " has no meaning with " +
                                    (chosen.empty() ? "the default" : chosen) + ", only with " +
                                    choice.name);
}

// Words that belong to an option, and were taken for meshes.
void check_inputs(const Command_line& command_line)
{
  std::error_code ignored;
  for (const std::string& input : command_line.inputs)
    if (!std::filesystem::exists(input, ignored))
    {
      if (!command_line.caps.empty() && (input == "flat" || input == "faired" || input == "hull"))
        throw std::invalid_argument("'" + input + "' is no mesh; caps are chosen by --close=" + input);
      if (is_pattern(input))
        throw std::invalid_argument("'" + input + "' is no mesh; an output is named by -o");
    }
}

bool is_collection(const Command_line& command_line)
{
  std::error_code ignored;
  return !command_line.output_folder.empty() || command_line.inputs.size() > 1 ||
         std::filesystem::is_directory(command_line.inputs.front(), ignored);
}

void check_collection(const CLI::App& app, const Command_line& command_line)
{
  const auto refuse = [&](const std::vector<const char*>& options, const std::string& reason)
  {
    for (const char* option : options)
      if (app.count(option) > 0)
        throw std::invalid_argument(option + reason);
  };
  if (!is_collection(command_line))
    return refuse({"--format", "--jobs", "--again"}, " has no meaning without --output-folder");
  if (command_line.output_folder.empty())
    throw std::invalid_argument("several meshes or a folder of meshes need --output-folder");
  refuse({"--report"}, " has no meaning with --output-folder; --format html writes a page for each mesh");
  refuse({"--output", "--json", "--borders", "--skeleton", "--rig", "--tips", "--labels", "--names"},
         " has no meaning with --output-folder");
  for (const std::string& format : command_line.formats)
    if (format != "html")
      check_output_format(format);
    else if (!can_write_report())
      throw std::invalid_argument("--format html: three.js was not found when this program was built");
  for (const std::string& input : command_line.inputs)
    if (input == "-")
      throw std::invalid_argument("the standard input is one mesh, which needs no --output-folder");
}

void check_hierarchy(const Segmentation_options& options)
{
  if (options.hierarchy && *options.hierarchy < *options.number_of_segments)
    throw std::invalid_argument("--of: '" + std::to_string(*options.hierarchy) + "' is less than the " +
                                std::to_string(*options.number_of_segments) + " segments of -k");
}

// What belongs to finding segments, beside segments that are given.
void check_labels(const CLI::App& app, const Command_line& command_line)
{
  if (!command_line.options.labels.empty())
    for (const char* option : {"--method", "--distance", "--seed", "--threads"})
      if (app.count(option) > 0)
        throw std::invalid_argument(std::string(option) + " has no meaning with --labels");
}

// Of a collection.
bool has_format_of_meshes(const Command_line& command_line)
{
  const std::vector<std::string>& formats = command_line.formats;
  return std::any_of(formats.begin(), formats.end(), [](const std::string& format)
                     { return format != "html" && holds_a_mesh("mesh." + format); });
}

void check_outputs(const Command_line& command_line)
{
  const std::vector<std::string>& outputs = command_line.outputs;
  for (const std::string& name : outputs)
    check_output_name(name);
  if (!command_line.caps.empty() && !has_format_of_meshes(command_line) &&
      std::none_of(outputs.begin(), outputs.end(),
                   [](const std::string& name) { return is_pattern(name) || holds_parts(name); }))
    throw std::invalid_argument(
      "--close has no meaning without a %d or %s in the name of an output, or .3mf, or --format "
      "with a format of meshes");
  if (command_line.has_connectors && command_line.caps != "flat")
    throw std::invalid_argument("--connectors has no meaning without --close=flat");
  if (!command_line.borders.empty() && lower_case_extension(command_line.borders) != ".vtp")
    throw std::invalid_argument("--borders: '" + command_line.borders + "' has not the extension .vtp");
  if (!command_line.skeleton.empty() && lower_case_extension(command_line.skeleton) != ".vtp")
    throw std::invalid_argument("--skeleton: '" + command_line.skeleton + "' has not the extension .vtp");
  if (const std::string extension = lower_case_extension(command_line.rig);
      !command_line.rig.empty() && extension != ".glb" && extension != ".gltf")
    throw std::invalid_argument("--rig: '" + command_line.rig + "' has not the extension .glb or .gltf");
}

// Options of formats that are not written would be ignored in silence.
void check_formats_of_options(const CLI::App& app, const Command_line& command_line)
{
  std::set<std::string> extensions;
  for (const std::string& name : command_line.outputs)
    extensions.insert(lower_case_extension(name));
  for (const std::string& format : command_line.formats)
    extensions.insert(lower_case_extension("mesh." + format));
  const auto check_option = [&](const char* option, const std::vector<std::string>& formats, const std::string& words)
  {
    if (app.count(option) > 0 && std::none_of(formats.begin(), formats.end(),
                                              [&](const std::string& format) { return extensions.count(format) > 0; }))
      throw std::invalid_argument(option + std::string(" has no meaning without an output in ") + words);
  };
  const std::vector<std::string>& outputs = command_line.outputs;
  if (app.count("--triangulate") > 0 && !has_format_of_meshes(command_line) &&
      std::none_of(outputs.begin(), outputs.end(), holds_a_mesh))
    throw std::invalid_argument("--triangulate has no meaning without an output of a mesh");
  check_option("--one-object", {".glb", ".gltf"}, "glTF");
  check_option("--array-name", {".vtp"}, "VTP");
  extensions.insert(lower_case_extension(command_line.rig));
  check_option("--colors", {".ply", ".obj", ".glb", ".gltf"}, "PLY, OBJ or glTF");
  check_option("--up", {".glb", ".gltf", ".usda"}, "glTF or USD");
}

std::string place_of(const std::string& name)
{
  return name == "-" ? name : place_of_file(name).string();
}

// No file may be written twice, or take the place of one that is read, by whatever names.
void check_names(const Command_line& command_line)
{
  std::vector<std::string> names, patterns;
  for (const std::string& name : command_line.outputs)
  {
    (is_pattern(name) ? patterns : names).push_back(name);
    if (const std::string companion = companion_of(name, command_line.options.formats); !companion.empty())
      names.push_back(companion);
  }
  for (const std::string& name : {command_line.json, command_line.report, command_line.borders,
                                  command_line.skeleton, command_line.rig})
    if (!name.empty())
      names.push_back(name);
  const std::vector<std::string> inputs = {command_line.inputs.front(), command_line.tips,
                                           command_line.options.labels, command_line.names};
  if (std::count(inputs.begin(), inputs.end(), "-") > 1)
    throw std::invalid_argument("'-' is named twice");
  std::set<std::string> read, places;
  for (const std::string& name : inputs)
    if (!name.empty() && name != "-" &&
        read.insert(place_of(name)).second) // "-" may be an output besides
      names.push_back(name);
  for (const std::string& name : names)
    if (!places.insert(place_of(name)).second)
      throw std::invalid_argument("'" + name + "' is named twice");
  for (std::size_t i = 0; i < patterns.size(); ++i)
  {
    for (const std::string& name : names)
      if (name != "-" && gives_part(patterns[i], name))
        throw std::invalid_argument("'" + name + "' is named twice: '" + patterns[i] +
                                    "' can give it, too");
    for (std::size_t j = 0; j < i; ++j)
      if (const auto name = common_part(patterns[j], patterns[i]))
        throw std::invalid_argument("'" + *name + "' is named twice: by '" + patterns[j] + "' and '" +
                                    patterns[i] + "'");
  }
}

} // namespace

void check(const CLI::App& app, const Command_line& command_line)
{
  try
  {
    check_meanings(app, methods(), command_line.options.method);
    check_meanings(app, distances(), command_line.options.distance);
    check_options(command_line.options);
    check_format_options(command_line.options.formats);
    check_inputs(command_line);
    check_collection(app, command_line);
    check_labels(app, command_line);
    check_hierarchy(command_line.options);
    check_outputs(command_line);
    check_formats_of_options(app, command_line);
    check_names(command_line);
    if (!command_line.report.empty() && !can_write_report())
      throw std::invalid_argument("--report: three.js was not found when this program was built");
  }
  catch (const std::invalid_argument& error)
  {
    throw CLI::ValidationError(error.what());
  }
}

} // namespace tool
