// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "collection/segment_collection.h"

#include "collection/list_meshes.h"
#include "collection/run_in_processes.h"
#include "command_line/Error.h"
#include "command_line/Progress_bar.h"
#include "reading/read_soup.h"
#include "segmentation/segment_file.h"
#include "segmentation/write_findings.h"
#include "writing/json.h"
#include "writing/outputs.h"
#include "writing/part_names.h"
#include "writing/write_output.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <set>
#include <system_error>
#include <vector>

namespace tool
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Tells of each mesh, as it is done.
class Teller
{
public:
  Teller(std::size_t number_of_meshes, bool is_quiet)
    : m_number_of_meshes(number_of_meshes),
      m_is_quiet(is_quiet),
      m_bar(!is_quiet && is_standard_error_a_terminal())
  {}

  // One mesh is done, and this is its line. A note has one of its own; so has a warning, which is in the line, where that is not shown.
  void tell(const std::string& line, bool is_error, const std::string& note = "", const std::string& warning = "")
  {
    ++m_number_of_told;
    m_bar.clear();
    const std::string place = "[" + std::to_string(m_number_of_told) + "/" +
                              std::to_string(m_number_of_meshes) + "] ";
    if (is_error)
      std::cerr << place << line << std::endl;
    else if (!m_is_quiet)
      std::cout << place << line << std::endl;
    if (!note.empty() && !m_is_quiet)
      std::cerr << place << note << std::endl;
    if (!warning.empty() && m_is_quiet)
      std::cerr << place << warning << std::endl;
    m_bar.show(double(m_number_of_told) / double(m_number_of_meshes), place);
  }

private:
  std::size_t m_number_of_meshes;
  std::size_t m_number_of_told = 0;
  bool m_is_quiet;
  Progress_bar m_bar;
};

class Collection
{
public:
  explicit Collection(const Command_line& command_line)
    : m_command_line(command_line),
      m_options(command_line.options),
      m_meshes(list_meshes(command_line.inputs, command_line.output_folder)),
      m_teller(m_meshes.size(), command_line.is_quiet)
  {
    m_options.caps = command_line.caps;
    for (const Mesh_in_collection& mesh : m_meshes)
      m_inputs.insert(place_of_file(mesh.input));
    check_outputs();
    for (const Mesh_in_collection& mesh : m_meshes)
      if (is_there(mesh))
        make_folder(path(mesh, "json").parent_path());
  }

  void segment_all()
  {
    std::vector<const Mesh_in_collection*> left;
    for (const Mesh_in_collection& mesh : m_meshes)
    {
      const Json record = record_of(mesh);
      if (const std::string other = other_mesh_in(record, mesh); !other.empty())
        tell_failure(mesh.input + ": " + path(mesh, "json").string() + " tells of " + other +
                     ", whose segments would be lost; another --output-folder is needed");
      else if (m_command_line.is_everything_done_again || !is_done(mesh, record))
        left.push_back(&mesh);
      else
      {
        ++m_number_of_skipped;
        tell_done(mesh, "already there", formats_in(record));
      }
    }
    run_in_processes(left.size(), m_command_line.jobs, [&](std::size_t i) { return segment(*left[i]); },
                     [&](std::size_t i, const Outcome& outcome) { tell(*left[i], outcome); });
  }

  std::size_t number_of_failures() const { return m_number_of_failures; }

  std::string result() const
  {
    const std::size_t all = m_meshes.size(), failed = m_number_of_failures, skipped = m_number_of_skipped;
    return std::to_string(all) + " meshes: " + std::to_string(all - failed - skipped) + " segmented, " +
           std::to_string(skipped) + " already there, " + std::to_string(failed) + " failed";
  }

private:
  // None of them may take the place of a mesh, or be taken for one the next time.
  void check_outputs() const
  {
    std::set<fs::path> folders;
    for (const fs::path& input : m_inputs)
      folders.insert(input.parent_path());
    for (const std::string& format : m_command_line.formats)
      for (const Mesh_in_collection& mesh : m_meshes)
        if (const fs::path output = path(mesh, format);
            has_mesh_extension(output.string()) &&
            folders.count(place_of_file(output.string()).parent_path()) > 0)
          throw Error(output.string(), "would be a mesh among those to be segmented; another --output-folder is needed");
  }

  static bool is_there(const Mesh_in_collection& mesh)
  {
    std::error_code ignored;
    return fs::exists(mesh.input, ignored);
  }

  static void make_folder(const fs::path& folder)
  {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      throw Error(folder.string(), "cannot be made: " + error.message());
  }

  fs::path path(const Mesh_in_collection& mesh, const std::string& extension) const
  {
    return fs::path(m_command_line.output_folder) / (mesh.name + "." + extension);
  }

  fs::path folder_of_parts(const Mesh_in_collection& mesh) const
  {
    return fs::path(m_command_line.output_folder) / mesh.name;
  }

  // Is there a file for each segment in a format?
  bool is_in_parts(const std::string& format) const
  {
    return !m_options.caps.empty() && format != "html" && holds_a_mesh("mesh." + format) && !holds_parts("mesh." + format);
  }

  // What was written in a format, or the first part of it.
  fs::path output(const Mesh_in_collection& mesh, const std::string& format) const
  {
    return is_in_parts(format) ? folder_of_parts(mesh) / ("0." + format) : path(mesh, format);
  }

  // What is there of the mesh in formats that its record does not go with, and could pass for segments that it tells of.
  // Nothing of it is removed: who knows whose it is?
  std::string note_on_other_files(const Mesh_in_collection& mesh, const std::vector<std::string>& formats) const
  {
    std::set<fs::path> known = m_inputs;
    for (const std::string& format : formats)
      known.insert(place_of_file(path(mesh, format).string()));
    std::error_code ignored;
    std::string others;
    std::size_t number = 0;
    std::vector<std::string> extensions = output_extensions();
    extensions.push_back(".html");
    for (const std::string& extension : extensions)
      if (const fs::path other = path(mesh, extension.substr(1));
          fs::exists(other, ignored) && known.count(place_of_file(other.string())) == 0)
        others += (number++ == 0 ? "" : ", ") + other.string();
    return number == 0 ? ""
                       : others + (number == 1 ? " is" : " are") + " of another run than " + path(mesh, "json").string();
  }

  // What is there of parts of an earlier run with more segments.
  std::string note_on_other_parts(const Mesh_in_collection& mesh) const
  {
    std::string notes;
    if (m_options.caps.empty())
      return notes; // there are no parts, and the record need not be read
    const Json segments = record_of(mesh).value("segments", Json());
    if (!segments.is_number_unsigned())
      return notes;
    for (const std::string& format : m_command_line.formats)
      if (is_in_parts(format))
        if (const std::string note =
              note_on_further_parts((folder_of_parts(mesh) / ("%d." + format)).string(), segments.get<std::size_t>());
            !note.empty())
          notes += (notes.empty() ? "" : "; ") + note;
    return notes;
  }

  // No exception leaves it. The text does not name the mesh.
  Outcome segment(const Mesh_in_collection& mesh) const
  {
    try
    {
      Findings findings = segment_file(mesh.input, m_options, {}, [](const std::string&) {});
      findings.formats = m_command_line.formats;
      Output_names names;
      for (const std::string& format : m_command_line.formats)
        if (format == "html")
          names.report = path(mesh, format).string();
        else
          names.segments.push_back(path(mesh, format).string());
      if (!m_options.caps.empty())
      {
        names.caps = caps_of_name(m_options.caps);
        names.folder_of_parts = folder_of_parts(mesh).string();
      }
      names.json = path(mesh, "json").string();
      names.have_numbers = false;
      write_findings(findings, names);
      return {false, summary(findings) + (findings.note.empty() ? "" : " (" + findings.note + ")"),
              note_on_missing_segments(findings)};
    }
    catch (const std::bad_alloc&)
    {
      return {true, "out of memory"};
    }
    catch (const std::exception& error)
    {
      const std::string name = mesh.input + ": ", message = error.what();
      return {true, message.compare(0, name.size(), name) == 0 ? message.substr(name.size()) : message};
    }
  }

  void tell(const Mesh_in_collection& mesh, const Outcome& outcome)
  {
    if (outcome.is_failure)
      fail(mesh, mesh.input + ": " + outcome.text);
    else
      tell_done(mesh, outcome.text, m_command_line.formats, outcome.warning);
  }

  void tell_done(const Mesh_in_collection& mesh,
                 const std::string& text,
                 const std::vector<std::string>& formats,
                 const std::string& warning = "")
  {
    const std::string name = mesh.input + ": ", parts = note_on_other_parts(mesh);
    std::string others = note_on_other_files(mesh, formats);
    others += (others.empty() || parts.empty() ? "" : "; ") + parts;
    m_teller.tell(name + text, false, others.empty() ? "" : name + others, warning.empty() ? "" : name + warning);
  }

  Json record_of(const Mesh_in_collection& mesh) const
  {
    std::ifstream in(path(mesh, "json"));
    const Json record = Json::parse(in, nullptr, false);
    return record.is_object() ? record : Json::object();
  }

  // Those that were written with it; what else lies there may be of other segments.
  static std::vector<std::string> formats_in(const Json& record)
  {
    std::vector<std::string> formats;
    for (const Json& format : record.value("formats", Json::array()))
      if (format.is_string())
        formats.push_back(format.get<std::string>());
    return formats;
  }

  // The mesh that a record is of, if that is another file; empty if it is not, or is there no more. The name may have been
  // given from another folder, and then says nothing.
  static std::string other_mesh_in(const Json& record, const Mesh_in_collection& mesh)
  {
    const Json input = record.value("input", Json());
    if (!input.is_string())
      return "";
    const std::string other = input.get<std::string>();
    std::error_code error;
    return fs::exists(other, error) && place_of_file(other) != place_of_file(mesh.input) ? other : "";
  }

  // Was it segmented with the same options after the mesh was written? The record is the last of its files that appears.
  bool is_done(const Mesh_in_collection& mesh, const Json& record) const
  {
    std::error_code error;
    const auto written = fs::last_write_time(path(mesh, "json"), error);
    if (error || fs::last_write_time(mesh.input, error) > written || error)
      return false;
    const std::vector<std::string> formats = formats_in(record);
    for (const std::string& format : m_command_line.formats)
      if (std::find(formats.begin(), formats.end(), format) == formats.end() || !fs::exists(output(mesh, format), error))
        return false;
    if (record.value("format_version", 0) != json_format_version || record.contains("error"))
      return false;
    const Json options = describe(m_options);
    for (const auto& [key, value] : options.items())
      if (!record.contains(key) || record[key] != value)
        return false;
    return true;
  }

  // The record says so, too; then it is tried again the next time. Of a name that is no file, as of a slip, there is none.
  void fail(const Mesh_in_collection& mesh, const std::string& message)
  {
    tell_failure(is_there(mesh) ? record_failure(mesh, message) : message);
  }

  void tell_failure(const std::string& message)
  {
    ++m_number_of_failures;
    m_teller.tell(message, true);
  }

  // Returns what is to be told of it.
  std::string record_failure(const Mesh_in_collection& mesh, const std::string& message) const
  {
    const std::string others = note_on_other_files(mesh, {}), line = message + (others.empty() ? "" : "; " + others);
    try
    {
      const Json record = {
        {"format_version", json_format_version}, {"input", mesh.input}, {"error", line}};
      write_output(path(mesh, "json").string(), [&](std::ostream& out) { write_json(out, record); });
    }
    catch (const std::exception& error)
    {
      return line + "; " + error.what();
    }
    return line;
  }

  const Command_line& m_command_line;
  Segmentation_options m_options;
  std::vector<Mesh_in_collection> m_meshes;
  std::set<fs::path> m_inputs; // their places
  Teller m_teller;
  std::size_t m_number_of_failures = 0;
  std::size_t m_number_of_skipped = 0;
};

} // namespace

void segment_collection(const Command_line& command_line)
{
  Collection collection(command_line);
  collection.segment_all();
  if (collection.number_of_failures() > 0)
    throw Error(command_line.output_folder, collection.result());
  if (!command_line.is_quiet)
    std::cout << collection.result() << "\n";
  finish_standard_output();
}

} // namespace tool
