// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/segment_options.h"

#include "command_line/integer_option.h"
#include "reading/lower_case_extension.h"
#include "reading/read_soup.h"
#include "report/report.h"
#include "segmentation/segment.h"
#include "writing/outputs.h"
#include "writing/part_names.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace tool
{
namespace
{

std::vector<std::string> names(const std::vector<Choice>& choices)
{
  std::vector<std::string> result;
  for (const Choice& choice : choices)
    result.push_back(choice.name);
  return result;
}

std::string help(const std::string& text, const std::vector<Choice>& choices)
{
  std::string result = text;
  for (const Choice& choice : choices)
    result += "\n" + choice.name + ": " + choice.description;
  return result;
}

// Options of a distance or a method that was not chosen would be ignored in silence.
void check_meanings(const CLI::App& app, const std::vector<Choice>& choices, const std::string& chosen)
{
  for (const Choice& choice : choices)
    for (const std::string& option : choice.options)
      if (choice.name != chosen && app.count(option) > 0)
        throw std::invalid_argument(option + " has no meaning with " +
                                    (chosen.empty() ? "the default" : chosen) + ", only with " + choice.name);
}

// More of them would wait for each other, and the system refuses millions.
constexpr std::size_t most_threads = 1024;

// Words that belong to an option, and were taken for meshes.
void check_inputs(const Command_line& command_line)
{
  std::error_code ignored;
  for (const std::string& input : command_line.inputs)
    if (!std::filesystem::exists(input, ignored))
    {
      if (!command_line.caps.empty() && (input == "flat" || input == "faired"))
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
  refuse({"--output", "--json", "--report", "--borders", "--tips"}, " has no meaning with --output-folder");
  for (const std::string& format : command_line.formats)
    check_output_format(format);
  for (const std::string& input : command_line.inputs)
    if (input == "-")
      throw std::invalid_argument("the standard input is one mesh, which needs no --output-folder");
}

void check_outputs(const Command_line& command_line)
{
  const std::vector<std::string>& outputs = command_line.outputs;
  for (const std::string& name : outputs)
    check_output_name(name);
  if (!command_line.caps.empty() && std::none_of(outputs.begin(), outputs.end(), is_pattern))
    throw std::invalid_argument("--close has no meaning without a %d in the name of an output");
  if (!command_line.borders.empty() && lower_case_extension(command_line.borders) != ".vtp")
    throw std::invalid_argument("--borders: '" + command_line.borders + "' has not the extension .vtp");
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
    (is_pattern(name) ? patterns : names).push_back(name);
  for (const std::string& name : {command_line.json, command_line.report, command_line.borders})
    if (!name.empty())
      names.push_back(name);
  for (const std::string& name : {command_line.inputs.front(), command_line.tips})
    if (!name.empty() && name != "-") // which may be an output besides
      names.push_back(name);

  if (command_line.inputs.front() == "-" && command_line.tips == "-")
    throw std::invalid_argument("'-' is named twice");
  std::set<std::string> places;
  for (const std::string& name : names)
    if (!places.insert(place_of(name)).second)
      throw std::invalid_argument("'" + name + "' is named twice");
  for (std::size_t i = 0; i < patterns.size(); ++i)
  {
    for (const std::string& name : names)
      if (name != "-" && gives_part(patterns[i], name))
        throw std::invalid_argument("'" + name + "' is named twice: '" + patterns[i] + "' can give it, too");
    for (std::size_t j = 0; j < i; ++j)
      if (const auto name = common_part(patterns[j], patterns[i]))
        throw std::invalid_argument("'" + *name + "' is named twice: by '" + patterns[j] + "' and '" + patterns[i] + "'");
  }
}

constexpr const char* no_report = "three.js was not found when this program was built";

void check(const CLI::App& app, const Command_line& command_line)
{
  try
  {
    check_meanings(app, methods(), command_line.options.method);
    check_meanings(app, distances(), command_line.options.distance);
    check_options(command_line.options);
    check_inputs(command_line);
    check_collection(app, command_line);
    check_outputs(command_line);
    check_names(command_line);
    if (!command_line.report.empty() && !can_write_report())
      throw std::invalid_argument(std::string("--report: ") + no_report);
  }
  catch (const std::invalid_argument& error)
  {
    throw CLI::ValidationError(error.what());
  }
}

void add_segmentation_options(CLI::App& app, Segmentation_options& options)
{
  app
    .add_option("-k,--segments", options.number_of_segments,
                "number of segments; default: as many as there are evident protrusions")
    ->transform(integer("number of segments", 1))
    ->type_name("N");
  app.add_option("--method", options.method, help("how borders are found", methods()))
    ->check(CLI::IsMember(names(methods())).description(""))
    ->type_name("NAME")
    ->capture_default_str();
  app
    .add_option(
      "--distance", options.distance,
      help("distance on the surface; default: geodesic for paper, for minimum-cut its own", distances()))
    ->check(CLI::IsMember(names(distances())).description(""))
    ->type_name("NAME");
  app.add_option("--landmarks", options.landmarks, "share or number of faces that are landmarks")
    ->type_name("N%|N")
    ->capture_default_str();
  app.add_option("--eigenpairs", options.eigenpairs, "number of terms of the diffusion distance")
    ->transform(integer("number of terms", 1))
    ->type_name("N")
    ->capture_default_str();
  app
    .add_option("--time", options.time,
                "of the diffusion distance, from 0; at 1 the slowest term has decayed to 1/e")
    ->type_name("T")
    ->capture_default_str();
  app.add_option("--seed", options.seed, "of all that is random")
    ->transform(integer("seed", 0, (std::numeric_limits<decltype(options.seed)>::max)()))
    ->type_name("N")
    ->capture_default_str();
  app
    .add_option("--threads", options.threads,
                std::string("that segment a mesh; the segments are the same with any number of them") +
                  (can_use_threads() ? "" : "; not here: oneTBB was not found when this program was built"))
    ->transform(integer("number of threads", 1, most_threads))
    ->type_name("N")
    ->capture_default_str();
  app.add_flag("--smooth-borders", options.are_borders_smooth,
               "move borders, which run along edges, to smooth lines, and cut faces along them: meshes then have more\n"
               "faces, each with the number of the old one; .seg has for each old face the segment of its largest piece");
}

void add_output_options(CLI::App& app, Command_line& command_line)
{
  std::string outputs = "write the segments, as the extension says; may be repeated;\n"
                        "with %d or %03d in the name one mesh per segment, in a folder that is made if it is not there, as\n"
                        "no other is; - is the standard output, in SEG";
  for (const std::string& format : output_formats())
    outputs += "\n" + format;
  app.add_option("-o,--output", command_line.outputs, outputs)->allow_extra_args(false)->type_name("FILE");
  app
    .add_flag("--close{flat}", command_line.caps,
              "close the meshes of segments where they were cut off: all are closed if the input is.\n"
              "--close or --close=flat: with caps that two meshes share; their volumes add up to that of the input\n"
              "--close=faired: with round caps, of each mesh its own")
    ->check(CLI::IsMember({"flat", "faired"}).description(""));
  app
    .add_option("--borders", command_line.borders,
                "write the borders between segments as lines of VTK (.vtp), with both segments, length, value and\n"
                "probability of each")
    ->type_name("FILE");
  app.add_option("--json", command_line.json, "write what was found as JSON, - is the standard output")
    ->type_name("FILE");
  app
    .add_option("--report", command_line.report,
                "write a page for the browser: the mesh in 3D, to turn and to click on, and what is\n"
                "known of each segment" +
                  (can_write_report() ? "" : std::string("; not here: ") + no_report))
    ->type_name("FILE");
  app.add_flag("--quiet", command_line.is_quiet, "print errors only");
}

void add_collection_options(CLI::App& app, Command_line& command_line)
{
  app
    .add_option("--output-folder", command_line.output_folder,
                "write for each mesh its segments and a record in JSON here, under the mesh's name;\n"
                "what is there already and was made with the same options is not made again")
    ->type_name("FOLDER");
  app
    .add_option("--format", command_line.formats,
                "of the segments in --output-folder; may be repeated; default: seg")
    ->allow_extra_args(false)
    ->type_name("EXTENSION");
  app.add_option("--jobs", command_line.jobs, "so many meshes at once, each in a process of its own, with --output-folder")
    ->transform(integer("number of jobs", 1))
    ->type_name("N")
    ->capture_default_str();
  app.add_flag("--again", command_line.is_everything_done_again,
               "make again what is there in --output-folder");
}

} // namespace

void add_options(CLI::App& app, Command_line& command_line)
{
  app.set_version_flag("--version", std::string("segment_by_protrusions ") + PROTRUSION_SEGMENTATION_VERSION);
  app
    .add_option("input", command_line.inputs,
                "mesh: " + known_formats() +
                  ", each also compressed by gzip (.gz); - is the standard input;\n"
                  "what has no extension is recognized by how it begins;\n"
                  "with --output-folder any number of meshes and of folders")
    ->required()
    ->type_name("");
  add_segmentation_options(app, command_line.options);
  app
    .add_option("--tips", command_line.tips,
                "cut off the protrusions of these tips only: faces as the report saves them, {\"tips\": [12, 345]}")
    ->excludes("--segments")
    ->type_name("FILE");
  add_output_options(app, command_line);
  add_collection_options(app, command_line);
  app.callback(
    [&]()
    {
      check(app, command_line);
      if (command_line.options.distance.empty() && command_line.options.method == "paper")
        command_line.options.distance = "geodesic";
      if (command_line.formats.empty())
        command_line.formats = {"seg"};
    });
}

} // namespace tool
