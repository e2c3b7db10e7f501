// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// segment_by_protrusions INPUT [OPTION...]
//
// Splits a surface mesh into a body and its protrusions, and writes the segments in any of several
// formats.

#include "command_line/Error.h"
#include "command_line/Progress_bar.h"
#include "command_line/tool_main.h"
#include "reading/read_mesh.h"
#include "report/report.h"
#include "segmentation/segment.h"
#include "writing/Output_files.h"
#include "writing/json.h"
#include "writing/outputs.h"
#include "writing/write_output.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

using Options = tool::Segmentation_options;

struct Command_line
{
  std::string input;
  Options options;
  std::vector<std::string> outputs;
  std::string json;   // "-" is the standard output
  std::string report; // empty: none
  bool are_parts_closed = false;
  bool is_quiet = false;
};

std::vector<std::string> names(const std::vector<tool::Choice>& choices)
{
  std::vector<std::string> result;
  for (const tool::Choice& choice : choices)
    result.push_back(choice.name);
  return result;
}

std::string help(const std::string& text, const std::vector<tool::Choice>& choices)
{
  std::string result = text;
  for (const tool::Choice& choice : choices)
    result += "\n" + choice.name + ": " + choice.description;
  return result;
}

// Options of a distance or a method that was not chosen would be ignored in silence.
void check_meanings(const CLI::App& app,
                    const std::vector<tool::Choice>& choices,
                    const std::string& chosen)
{
  for (const tool::Choice& choice : choices)
    for (const std::string& option : choice.options)
      if (choice.name != chosen && app.count(option) > 0)
        throw std::invalid_argument(option + " has no meaning with " + (chosen.empty() ? "the default" : chosen) +
                                    ", only with " + choice.name);
}

void check_names(const Command_line& command_line)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  std::set<fs::path> seen = {fs::weakly_canonical(command_line.input, ignored)};
  std::vector<std::string> all = command_line.outputs;
  for (const std::string& name : all)
    tool::check_output_name(name);
  if (!command_line.json.empty() && command_line.json != "-")
    all.push_back(command_line.json);
  if (!command_line.report.empty())
    all.push_back(command_line.report);
  for (const std::string& name : all)
    if (!seen.insert(fs::weakly_canonical(name, ignored)).second)
      throw std::invalid_argument("'" + name + "' is named twice");
}

constexpr const char* no_report = "three.js was not found when this program was built";

void check(const CLI::App& app, const Command_line& command_line)
{
  try
  {
    check_meanings(app, tool::methods(), command_line.options.method);
    check_meanings(app, tool::distances(), command_line.options.distance);
    tool::check_options(command_line.options);
    check_names(command_line);
    if (command_line.are_parts_closed &&
        std::none_of(command_line.outputs.begin(), command_line.outputs.end(), tool::is_pattern))
      throw std::invalid_argument("--close has no meaning without a %d in the name of an output");
    if (!command_line.report.empty() && !tool::can_write_report())
      throw std::invalid_argument(std::string("--report: ") + no_report);
  }
  catch (const std::invalid_argument& error)
  {
    throw CLI::ValidationError(error.what());
  }
}

// All options, and nowhere else.
void add_options(CLI::App& app, Command_line& command_line)
{
  Options& options = command_line.options;
  app.add_option("input", command_line.input, "mesh: " + tool::known_formats())
      ->required()
      ->type_name("INPUT");
  app.add_option("-k,--segments", options.number_of_segments,
                 "number of segments; default: as many as there are evident protrusions")
      ->check(CLI::Validator(CLI::PositiveNumber).description(""))
      ->type_name("N");
  app.add_option("--method", options.method, help("how borders are found", tool::methods()))
      ->check(CLI::IsMember(names(tool::methods())).description(""))
      ->type_name("NAME")
      ->capture_default_str();
  app.add_option("--distance", options.distance,
                 help("distance on the surface; default: geodesic for paper, for minimum-cut its own", tool::distances()))
      ->check(CLI::IsMember(names(tool::distances())).description(""))
      ->type_name("NAME");
  app.add_option("--landmarks", options.landmarks, "share or number of faces that are landmarks")
      ->type_name("N%|N")
      ->capture_default_str();
  app.add_option("--eigenpairs", options.eigenpairs, "number of terms of the diffusion distance")
      ->check(CLI::Validator(CLI::PositiveNumber).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--time", options.time,
                 "of the diffusion distance, from 0; at 1 the slowest term has decayed to 1/e")
      ->type_name("T")
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of all that is random")
      ->type_name("N")
      ->capture_default_str();

  std::string outputs = "write the segments, as the extension says; may be repeated;\n"
                        "with %d in the name one mesh per segment";
  for (const std::string& format : tool::output_formats())
    outputs += "\n" + format;
  app.add_option("-o,--output", command_line.outputs, outputs)
      ->allow_extra_args(false)
      ->type_name("FILE");
  app.add_flag("--close", command_line.are_parts_closed,
               "close the meshes of segments where they were cut off; so all are closed if the input is,\n"
               "and their volumes add up to that of the input");
  app.add_option("--json", command_line.json,
                 "write what was found as JSON, - is the standard output")
      ->type_name("FILE");
  app.add_option("--report", command_line.report,
                 "write a page for the browser: the mesh in 3D, to turn and to click on, and what is\n"
                 "known of each segment" +
                     (tool::can_write_report() ? "" : std::string("; not here: ") + no_report))
      ->type_name("FILE");
  app.add_flag("--quiet", command_line.is_quiet, "print errors only");
  app.callback([&]() {
    check(app, command_line);
    if (options.distance.empty() && options.method == "paper")
      options.distance = "geodesic";
  });
}

void check_outputs_can_be_written(const Command_line& command_line)
{
  for (const std::string& name : command_line.outputs)
    if (!tool::is_pattern(name))
      tool::Output_files::check(name);
  for (const std::string& name : {command_line.json, command_line.report})
    if (!name.empty())
      tool::Output_files::check(name);
}

// Why there are not as many segments as were asked for, or no protrusions, or nothing.
std::string note_on_number(const Options& options, const tool::Segmentation& segmentation)
{
  const std::size_t found = segmentation.number_of_segments;
  const std::size_t wanted = options.number_of_segments.value_or(found);
  std::ostringstream note;
  if (found < wanted)
    note << "found " << found << " of " << wanted
         << " segments: no further protrusion has a border";
  else if (found > wanted)
    note << "found " << found << " segments instead of " << wanted << ": each of the mesh's "
         << found << " connected components is at least one";
  else if (!options.number_of_segments && segmentation.record.protrusions().empty())
    note << "found no evident protrusion; -k N asks for a number of segments";
  return note.str();
}

tool::Segmentation segment(const tool::Mesh& mesh, const Command_line& command_line)
{
  const std::size_t wanted = command_line.options.number_of_segments.value_or(0);
  if (wanted > mesh.number_of_faces())
    throw tool::Error(command_line.input, "has " + std::to_string(mesh.number_of_faces()) +
                                              " faces, too few for " + std::to_string(wanted) +
                                              " segments");
  tool::Progress_bar bar(!command_line.is_quiet && tool::is_standard_error_a_terminal());
  return tool::segment(mesh, command_line.options,
                       [&](double share, const std::string& stage, std::size_t protrusions) {
                         bar.show(share, std::to_string(protrusions) + " protrusions  " + stage);
                       });
}

void print_summary(const Command_line& command_line, const tool::Findings& findings)
{
  const tool::Segmentation& segmentation = findings.segmentation;
  if (!findings.note.empty())
    std::cerr << "segment_by_protrusions: " << command_line.input << ": " << findings.note << std::endl;
  if (command_line.json == "-")
    return; // nothing else shall be on the standard output
  std::cout << command_line.input << ": " << segmentation.segment_ids.size() << " faces, "
            << segmentation.number_of_segments << " segments, " << std::fixed
            << std::setprecision(3) << segmentation.seconds << " s\n";
  for (const std::string& name : command_line.outputs)
    std::cout << "wrote " << name << "\n";
  for (const std::string& name : {command_line.json, command_line.report})
    if (!name.empty())
      std::cout << "wrote " << name << "\n";
}

void run(const Command_line& command_line)
{
  check_outputs_can_be_written(command_line);
  const tool::Mesh mesh = tool::read_mesh(command_line.input);
  tool::Findings findings = {command_line.input, command_line.options, segment(mesh, command_line), ""};
  findings.note = note_on_number(findings.options, findings.segmentation);

  tool::Output_files files;
  for (const std::string& name : command_line.outputs)
    tool::add_output(name, mesh, findings.segmentation, command_line.are_parts_closed, files);
  if (!command_line.json.empty())
    files.add(command_line.json, [&](std::ostream& out) { tool::write_json(out, findings); });
  if (!command_line.report.empty())
    files.add(command_line.report,
              [&](std::ostream& out) { tool::write_report(out, mesh, findings); });
  files.publish();
  if (!command_line.is_quiet)
    print_summary(command_line, findings);
  tool::finish_standard_output();
}

int main(int argc, char** argv)
{
  Command_line command_line;
  CLI::App app("Splits a surface mesh into a body and its protrusions.", "segment_by_protrusions");
  add_options(app, command_line);
  return tool::main(app, argc, argv, [&]() { run(command_line); });
}
