// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/segment_file.h"

#include "command_line/Error.h"
#include "reading/read_mesh.h"
#include "report/report.h"
#include "segmentation/segment.h"
#include "writing/Output_files.h"
#include "writing/closed_parts.h"
#include "writing/json.h"
#include "writing/outputs.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstddef>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <sstream>
#include <utility>
#include <vector>

namespace tool
{
namespace
{

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// From there on a warning comes first: exact distances take minutes, and so does that many eigenpairs.
constexpr std::size_t many_faces_for_exact_distances = 5000;
constexpr std::size_t many_eigenpairs = 100;

// Why there are not as many segments as were asked for, or no protrusions, or nothing.
std::string note_on_number(const Segmentation_options& options, const Segmentation& segmentation)
{
  const std::size_t found = segmentation.number_of_segments;
  const std::size_t wanted = options.number_of_segments.value_or(found);
  std::ostringstream note;
  if (found < wanted)
    note << "found " << found << " of " << wanted << " segments: no further protrusion has a border";
  else if (found > wanted)
    note << "found " << found << " segments instead of " << wanted << ": each of the mesh's " << found
         << " connected components is at least one";
  else if (!options.number_of_segments && segmentation.record.protrusions().empty())
    note << "found no evident protrusion; -k N asks for a number of segments";
  return note.str();
}

void warn_of_time(const Findings& findings, const Warn& warn)
{
  const std::size_t faces = findings.mesh.mesh.number_of_faces();
  const Segmentation_options& options = findings.options;
  if (options.distance == "exact" && faces > many_faces_for_exact_distances)
    warn("exact distances on " + std::to_string(faces) +
         " faces may take very long; --distance heat is fast");
  if (options.distance == "diffusion" && options.eigenpairs > many_eigenpairs && faces > options.eigenpairs)
    warn(std::to_string(options.eigenpairs) + " eigenpairs on " + std::to_string(faces) +
         " faces may take very long; " + std::to_string(default_number_of_eigenpairs()) + " are the default");
}

std::vector<Segmented_soup> make_closed_parts(const Findings& findings)
{
  const Segmentation& segmentation = findings.segmentation;
  std::vector<std::size_t> parents(segmentation.number_of_segments);
  std::iota(parents.begin(), parents.end(), std::size_t(0));
  for (const Protrusion& protrusion : segmentation.record.protrusions())
    parents[protrusion.segment] = protrusion.parent;
  std::vector<Segmented_soup> parts;
  for (Polygon_soup& part : closed_parts(findings.mesh.mesh, segmentation.segment_ids, parents))
  {
    const std::size_t number_of_faces = part.polygons.size();
    parts.push_back({std::move(part), std::vector<std::size_t>(number_of_faces, parts.size())});
  }
  return parts;
}

std::string join_notes(const std::string& first, const std::string& second)
{
  return first + (first.empty() || second.empty() ? "" : "; ") + second;
}

} // namespace

Findings segment_file(const std::string& input,
                      const Segmentation_options& options,
                      const Recorder::Progress& progress,
                      const Warn& warn)
{
  const Clock::time_point start = Clock::now();
  Findings findings;
  findings.input = input;
  findings.options = options;
  findings.mesh = read_input_mesh(input);
  findings.seconds_for_file = seconds_since(start);
  const std::size_t faces = findings.mesh.mesh.number_of_faces();
  const std::size_t wanted = options.number_of_segments.value_or(0);
  if (wanted > faces)
    throw Error(input, "has " + std::to_string(faces) + " faces, too few for " + std::to_string(wanted) +
                         " segments");
  warn_of_time(findings, warn);
  findings.segmentation = segment(findings.mesh.mesh, options, progress);
  findings.note = join_notes(describe(findings.mesh.repairs), note_on_number(options, findings.segmentation));
  return findings;
}

void check_can_be_written(const Output_names& names)
{
  for (const std::string& name : names.segments)
    if (!is_pattern(name))
      Output_files::check(name);
  for (const std::string& name : {names.json, names.report})
    if (!name.empty())
      Output_files::check(name);
}

void write_findings(Findings& findings, const Output_names& names)
{
  const Clock::time_point start = Clock::now();
  const Segmented_soup segmented = {findings.mesh.soup,
                                    spread(findings.segmentation.segment_ids, findings.mesh)};
  Output_files files;
  for (const std::string& name : names.segments)
    if (names.are_parts_closed && is_pattern(name))
      add_parts(name, make_closed_parts(findings), files);
    else
      add_output(name, segmented, findings.segmentation.number_of_segments, files);
  if (!names.report.empty())
    files.add(names.report, [&](std::ostream& out) { write_report(out, findings); });
  findings.seconds_for_writing = seconds_since(start); // the record, which tells of it, is not counted
  if (!names.json.empty())
    files.add(names.json, [&](std::ostream& out) { write_json(out, describe(findings)); });
  files.publish();
}

std::string summary(const Findings& findings)
{
  std::ostringstream line;
  line << findings.mesh.label_giver.size() << " faces, " << findings.segmentation.number_of_segments
       << " segments, " << std::fixed << std::setprecision(3) << findings.seconds() << " s";
  return line.str();
}

} // namespace tool
