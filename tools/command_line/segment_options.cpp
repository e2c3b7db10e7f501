// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/segment_options.h"

#include "command_line/Help_formatter.h"
#include "command_line/check_command_line.h"
#include "command_line/connector_options.h"
#include "command_line/integer_option.h"
#include "command_line/number.h"
#include "command_line/output_options.h"
#include "reading/read_soup.h"
#include "segmentation/segment.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace tool {
namespace {

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

// More of them would wait for each other, and the system refuses millions.
constexpr std::size_t most_threads = 1024;

std::string problem_with_distance(const std::string& text)
{
  const std::optional<double> distance = number<double>(text);
  return distance && *distance >= 0 && std::isfinite(*distance) ? "" : "'" + text + "' is no distance";
}

std::string problem_with_gap(const std::string& text)
{
  if (text == "auto")
    return "";
  return number<double>(text) == 0. ? "'" + text + "' is no distance above 0" : problem_with_distance(text);
}

void add_segmentation_options(CLI::App& app, Command_line& command_line)
{
  const char* group = "Segmentation";
  Segmentation_options& options = command_line.options;
  app
    .add_option("-k,--segments", options.number_of_segments,
                "number of segments. Without it, segmentation stops where no further cut is good enough.")
    ->transform(integer("number of segments", 1))
    ->type_name("N")
    ->group(group);
  app
    .add_option("--of", options.hierarchy,
                "with -k N: the N nested segments that the page of --report shows for N of M. -k N alone "
                "is the best "
                "segmentation into N, and may differ.")
    ->transform(integer("number of segments", 1))
    ->needs("--segments")
    ->type_name("M")
    ->group(group);
  app
    .add_option(
      "--tips", command_line.tips,
      "cut off only the protrusions of these faces: {\"tips\": [12, 345]}, as the page of --report saves "
      "them. Not with -k.")
    ->excludes("--segments")
    ->type_name("FILE")
    ->group(group);
  app
    .add_option(
      "--weld", options.weld_distance,
      "join corners on borders that are up to this distance apart, and corners to edges. Without it, "
      "those that differ by rounding are joined; 0: only equal ones.")
    ->check(CLI::Validator(problem_with_distance, ""))
    ->type_name("DISTANCE")
    ->group(group);
  app
    .add_flag(
      "--join-pieces{auto}", command_line.joining,
      "segment loose pieces as one shape: pieces that touch, overlap or are less than the gap apart. -k "
      "counts parts and not pieces; hidden pieces go with what covers them. --close writes parts of the "
      "surface around the pieces. The gap is a distance; without it, a fortieth of the size.")
    ->check(CLI::Validator(problem_with_gap, ""))
    ->option_text("[=GAP]")
    ->excludes("--weld")
    ->group(group);
  app
    .add_option(
      "--labels", options.labels,
      "take the segments from a file instead: .seg, .npy, .json, or face data \"segment\" or \"label\" of a "
      "PLY or VTP file, as of INPUT itself")
    ->excludes("--segments")
    ->excludes("--tips")
    ->excludes("--join-pieces")
    ->type_name("FILE")
    ->group(group);
  app
    .add_option(
      "--names", command_line.names,
      "names of segments for groups, nodes and %s: {\"names\": [{\"face\": 12, \"name\": \"tail\"}]}, "
      "as the page of --report saves them. Those in the file of --tips need no --names.")
    ->type_name("FILE")
    ->group(group);
  app.add_option("--method", options.method, help("how borders are found", methods()))
    ->check(CLI::IsMember(names(methods())).description(""))
    ->type_name("NAME")
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--seed", options.seed, "seed of all random choices; the same seed gives the same result")
    ->transform(integer("seed", 0, (std::numeric_limits<decltype(options.seed)>::max)()))
    ->type_name("N")
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--threads", options.threads,
                std::string("number of threads, at most 1024; does not change the result") +
                  (can_use_threads() ? "" : "\nNot available: oneTBB was not found at build time."))
    ->transform(integer("number of threads", 1, most_threads))
    ->type_name("N")
    ->capture_default_str()
    ->group(group);
}

void add_options_of_distances(CLI::App& app, Segmentation_options& options)
{
  const char* group = "The paper's method";
  app
    .add_option(
      "--distance", options.distance,
      help(
        "distance on the surface. The default is geodesic for --method paper; --method minimum-cut has "
        "a distance of its own.",
        distances()))
    ->check(CLI::IsMember(names(distances())).description(""))
    ->type_name("NAME")
    ->group(group);
  app.add_option("--landmarks", options.landmarks, "share or number of the faces that are landmarks")
    ->type_name("N%|N")
    ->capture_default_str()
    ->group(group);
  app.add_option("--eigenpairs", options.eigenpairs, "number of terms of the diffusion distance")
    ->transform(integer("number of terms", 1))
    ->type_name("N")
    ->capture_default_str()
    ->group(group);
  app
    .add_option(
      "--time", options.time,
      "time of the diffusion distance, 0 or more; after a time of 1 the slowest term has decayed to 1/e")
    ->type_name("T")
    ->capture_default_str()
    ->group(group);
}

void add_collection_options(CLI::App& app, Command_line& command_line)
{
  const char* group = "Many meshes";
  app
    .add_option(
      "--output-folder", command_line.output_folder,
      "segment any number of meshes and folders. Write the segments and a record in JSON of each mesh "
      "into this folder. What is there and was made with the same options is skipped.")
    ->type_name("FOLDER")
    ->group(group);
  app
    .add_option(
      "--format", command_line.formats,
      "format of the segments (default: seg), or html, a page as of --report; may be repeated. With "
      "--close, meshes become a folder of closed parts each.")
    ->allow_extra_args(false)
    ->type_name("EXTENSION")
    ->group(group);
  app.add_option("--jobs", command_line.jobs, "number of meshes at once, each in its own process")
    ->transform(integer("number of jobs", 1))
    ->type_name("N")
    ->capture_default_str()
    ->group(group);
  app.add_flag("--again", command_line.is_everything_done_again, "skip nothing")->group(group);
}

void add_help(CLI::App& app)
{
  complete_help(
    app, "[OPTION...] INPUT...", "Input",
    {{"segment_by_protrusions horse.obj -o horse.ply", "a coloured mesh"},
     {"segment_by_protrusions horse.obj -k 7 --report horse.html",
      "seven segments, a page for the browser"},
     {"segment_by_protrusions horse.obj -o 'parts/%d.obj' --close", "a closed mesh of each segment"},
     {"segment_by_protrusions horse.stl -o '%d.stl' --close --connectors --tolerance 0.2",
      "parts with pegs and sockets, to be printed and put together"},
     {"segment_by_protrusions horse.obj --labels a.seg --names a.json -o 'parts/%s.obj' --close",
      "closed meshes of segments that were edited and named in the page"},
     {"segment_by_protrusions meshes --output-folder segments --jobs 2", "all meshes in a folder"}});
}

} // namespace

void add_options(CLI::App& app, Command_line& command_line)
{
  app
    .add_option(
      "INPUT", command_line.inputs,
      "a mesh; - is the standard input. With --output-folder, any number of meshes and folders.\n"
      "Formats: " +
        known_formats() +
        "; each also compressed by gzip (.gz).\n"
        "A file without extension is recognized by how it begins.")
    ->required()
    ->type_name("");
  add_output_options(app, command_line);
  add_connector_options(app, command_line);
  add_segmentation_options(app, command_line);
  add_options_of_distances(app, command_line.options);
  add_collection_options(app, command_line);
  add_help(app);
  app.callback(
    [&]()
    {
      command_line.options.are_pieces_joined = !command_line.joining.empty();
      command_line.options.gap = number<double>(command_line.joining);
      if (command_line.has_connectors)
        command_line.options.connectors = command_line.connectors;
      check(app, command_line);
      if (command_line.options.distance.empty() && command_line.options.method == "paper")
        command_line.options.distance = "geodesic";
      if (command_line.formats.empty())
        command_line.formats = {"seg"};
    });
}

} // namespace tool
