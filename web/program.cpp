// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program.h"

#include "command_line/Error.h"
#include "command_line/read_tips.h"
#include "command_line/segment_options.h"
#include "example_meshes/mesh_of_shape.h"
#include "example_meshes/shapes.h"
#include "reading/read_soup.h"
#include "report/report_data.h"
#include "segmentation/join_segments.h"
#include "segmentation/name_segments.h"
#include "segmentation/segment.h"
#include "segmentation/segment_file.h"
#include "segmentation/write_findings.h"
#include "writing/Zip_archive.h"
#include "writing/write_mesh.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* output_folder = "out";

std::optional<tool::Findings> last_findings;

// What a function of the page returns, in place of an exception the tool's message.
const char* answer(const std::function<std::string()>& run)
{
  static std::string text;
  const auto error = [&](const std::string& message) {
    text = Json({{"error", message}}).dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  text.clear();
  text.shrink_to_fit();
  try
  {
    text = run();
  }
  catch (const std::bad_alloc&)
  {
    error("out of memory: a page has at most 4 GB");
  }
  catch (const std::exception& exception)
  {
    error(exception.what());
  }
  return text.c_str();
}

tool::Command_line parse(std::vector<std::string> words)
{
  tool::Command_line command_line;
  CLI::App app("", "segment_by_protrusions");
  tool::add_options(app, command_line);
  std::reverse(words.begin(), words.end()); // as CLI11 takes them
  try
  {
    app.parse(words);
  }
  catch (const CLI::Success&)
  {
    throw tool::Error("a page has no --help");
  }
  return command_line;
}

void show(double share, const std::string& stage, std::size_t protrusions)
{
  page_progress(share, stage.c_str(), int(protrusions));
}

std::string segment(const tool::Command_line& command_line)
{
  last_findings.reset();
  tool::Segmentation_options options = command_line.options;
  const tool::Picked_tips picked = tool::read_tips_and_names(command_line.tips, command_line.names);
  options.tips = picked.faces;
  last_findings = tool::segment_file(command_line.inputs.front(), options, show,
                                     [](const std::string& warning) { page_warning(warning.c_str()); });
  tool::name_segments(*last_findings, picked);
  return "{\"data\":" + tool::report_data(*last_findings) + "}";
}

// Changes the segments as the page did, as long as it lives.
class Edit
{
public:
  Edit(tool::Findings& findings,
       const std::vector<std::size_t>& joined,
       const std::vector<std::string>& names)
    : m_findings(findings),
      m_segmentation(findings.segmentation),
      m_names(findings.names),
      m_note(findings.note)
  {
    if (findings.smoothed)
      m_smoothed_ids = findings.smoothed->segment_ids;
    std::vector<bool> is_joined(findings.segmentation.number_of_segments, false);
    for (const std::size_t segment : joined)
      is_joined.at(segment) = true;
    const std::vector<std::size_t> numbers = tool::join_segments(findings.segmentation, is_joined);
    if (findings.smoothed)
      for (std::size_t& segment : findings.smoothed->segment_ids)
        segment = numbers[segment];
    findings.names = names;
    if (!names.empty())
      findings.names.resize(findings.segmentation.number_of_segments);
  }
  Edit(const Edit&) = delete;
  Edit& operator=(const Edit&) = delete;
  ~Edit()
  {
    m_findings.segmentation = m_segmentation;
    m_findings.names = m_names;
    m_findings.note = m_note;
    if (m_findings.smoothed)
      m_findings.smoothed->segment_ids = m_smoothed_ids;
  }

private:
  tool::Findings& m_findings;
  tool::Segmentation m_segmentation;
  std::vector<std::string> m_names;
  std::string m_note;
  std::vector<std::size_t> m_smoothed_ids;
};

std::vector<std::string> names_of_outputs()
{
  std::vector<std::string> result;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(output_folder))
    if (entry.is_regular_file())
      result.push_back(fs::relative(entry.path(), output_folder).generic_string());
  std::sort(result.begin(), result.end());
  return result;
}

void pack(const std::string& archive)
{
  const std::vector<std::string> names = names_of_outputs();
  std::ofstream out(fs::path(output_folder) / archive, std::ios::binary);
  tool::Zip_archive zip(out);
  for (const std::string& name : names)
  {
    const fs::path file = fs::path(output_folder) / name;
    std::ostringstream content;
    content << std::ifstream(file, std::ios::binary).rdbuf();
    zip.add(name, content.str());
    fs::remove(file);
  }
  zip.finish();
  if (!out.flush())
    throw tool::Error(archive, "cannot be written");
}

std::string write(const Json& request)
{
  if (!last_findings)
    throw tool::Error("nothing is segmented yet");
  fs::remove_all(output_folder);
  fs::create_directories(output_folder);
  const tool::Command_line command_line = parse(request.at("words"));
  tool::Findings& findings = *last_findings;
  {
    const Edit edit(findings, request.at("joined"), request.at("names"));
    findings.options.formats = command_line.options.formats;
    tool::write_findings(findings,
                         {command_line.outputs, "", command_line.json, command_line.borders,
                          command_line.skeleton, command_line.rig, tool::caps_of_name(command_line.caps)},
                         show);
  }
  if (const std::string archive = request.at("archive"); !archive.empty())
    pack(archive);
  return Json({{"files", names_of_outputs()}}).dump();
}

Json described(const std::vector<tool::Choice>& choices)
{
  Json result = Json::array();
  for (const tool::Choice& choice : choices)
    result.push_back({{"name", choice.name}, {"description", choice.description}});
  return result;
}

} // namespace

const char* page_about()
{
  return answer(
    []()
    {
      Json examples = Json::array();
      for (const auto& shape : example_shapes::shapes())
        examples.push_back(shape.first);
      return Json({{"version", PROTRUSION_SEGMENTATION_VERSION},
                   {"methods", described(tool::methods())},
                   {"distances", described(tool::distances())},
                   {"formats", tool::known_formats()},
                   {"examples", examples}})
        .dump();
    });
}

const char* page_make_example(const char* shape, int number_of_faces)
{
  return answer(
    [&]()
    {
      page_progress(0, "making the example", 0);
      const std::string file = std::string(shape) + ".off";
      tool::write_mesh(file, example_shapes::mesh_of_shape(example_shapes::shapes().at(shape)(),
                                                           std::size_t(number_of_faces)));
      return Json({{"file", file}}).dump();
    });
}

const char* page_segment(const char* words)
{
  return answer([&]() { return segment(parse(Json::parse(words))); });
}

const char* page_write(const char* request)
{
  return answer([&]() { return write(Json::parse(request)); });
}
