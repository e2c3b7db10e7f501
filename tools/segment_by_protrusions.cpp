// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// segment_by_protrusions [OPTION...] INPUT...
//
// Splits a surface mesh into a body and its protrusions, or many meshes, and writes the segments.

#include "collection/segment_collection.h"
#include "command_line/Error.h"
#include "command_line/Progress_bar.h"
#include "command_line/read_tips.h"
#include "command_line/segment_options.h"
#include "command_line/tool_main.h"
#include "segmentation/name_segments.h"
#include "segmentation/segment_file.h"
#include "segmentation/write_findings.h"
#include "writing/outputs.h"
#include "writing/part_names.h"
#include "writing/write_output.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

namespace {

constexpr const char* program = "segment_by_protrusions";

void warn(const tool::Command_line& command_line, const std::string& text)
{
  std::cerr << program << ": " << command_line.inputs.front() << ": " << text << std::endl;
}

void tell(const tool::Command_line& command_line, const std::string& text)
{
  if (!command_line.is_quiet)
    warn(command_line, text);
}

void tell_if_any(const tool::Command_line& command_line, const std::string& note)
{
  if (!note.empty())
    tell(command_line, note);
}

void print_summary(const tool::Command_line& command_line, const tool::Findings& findings)
{
  tell_if_any(command_line, findings.note);
  const auto& outputs = command_line.outputs;
  for (const std::string& name : outputs)
    if (tool::is_pattern(name))
      tell_if_any(command_line,
                  tool::note_on_further_parts(name, findings.segmentation.number_of_segments));
  if (command_line.json == "-" || std::find(outputs.begin(), outputs.end(), "-") != outputs.end())
    return; // nothing else shall be on the standard output
  const std::vector<std::string> others = {command_line.json, command_line.report, command_line.borders,
                                           command_line.skeleton, command_line.rig};
  const bool is_anything_written = !outputs.empty() || std::any_of(others.begin(), others.end(),
                                                                   [](const std::string& name) { return !name.empty(); });
  std::cout << findings.input << ": " << tool::summary(findings)
            << (is_anything_written ? "" : " (nothing written: see -o, --report)") << "\n";
  for (const std::string& name : outputs)
  {
    const std::size_t files = findings.segmentation.number_of_segments;
    std::cout << "wrote " << name
              << (tool::is_pattern(name)
                    ? " (" + std::to_string(files) + (files == 1 ? " file)" : " files)")
                    : "");
    if (const std::string companion = tool::companion_of(name, command_line.options.formats); !companion.empty())
      std::cout << " and " << companion;
    std::cout << "\n";
  }
  for (const std::string& name : others)
    if (!name.empty())
      std::cout << "wrote " << name << "\n";
}

// To read it takes so long that it is told at once.
bool is_large(const std::string& file)
{
  constexpr std::uintmax_t large = 30000000; // bytes
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  return !error && size > large;
}

void segment_one(const tool::Command_line& command_line)
{
  tool::Output_names names = {command_line.outputs, command_line.report, command_line.json,
                              command_line.borders, command_line.skeleton, command_line.rig,
                              tool::caps_of_name(command_line.caps)};
  tool::Segmentation_options options = command_line.options;
  const tool::Picked_tips picked = tool::read_tips_and_names(command_line.tips, command_line.names);
  options.tips = picked.faces;
  tool::check_can_be_written(names, options.formats);
  tool::Progress_bar bar(!command_line.is_quiet && tool::is_standard_error_a_terminal(),
                         is_large(command_line.inputs.front()) ? std::chrono::seconds(0)
                                                               : std::chrono::seconds(2));
  const auto show = [&](double share, const std::string& stage, std::size_t protrusions)
  {
    bar.show(share, (protrusions == 0   ? ""
                     : protrusions == 1 ? "1 protrusion  "
                                        : std::to_string(protrusions) + " protrusions  ") +
                      stage);
  };
  tool::Findings findings = tool::segment_file(command_line.inputs.front(), options, show,
                                               [&](const std::string& warning)
                                               { tell(command_line, warning); });
  tool::name_segments(findings, picked);
  tool::write_findings(findings, names, show);
  bar.clear();
  if (!command_line.is_quiet)
    print_summary(command_line, findings);
  else if (const std::string note = tool::note_on_missing_segments(findings); !note.empty())
    warn(command_line, note);
  tool::finish_standard_output();
}

} // namespace

int main(int argc, char** argv)
{
  tool::Command_line command_line;
  CLI::App app("Splits a surface mesh into a body and its protrusions.", program);
  tool::add_options(app, command_line);
  return tool::main(app, argc, argv,
                    [&]()
                    {
                      if (command_line.output_folder.empty())
                        segment_one(command_line);
                      else
                        segment_collection(command_line);
                    });
}
