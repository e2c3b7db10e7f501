// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/write_findings.h"

#include "command_line/Error.h"
#include "reading/lower_case_extension.h"
#include "report/report.h"
#include "segmentation/make_closed_parts.h"
#include "segmentation/timing.h"
#include "writing/Output_files.h"
#include "writing/borders.h"
#include "writing/carried_attributes.h"
#include "writing/json.h"
#include "writing/outputs.h"
#include "writing/part_names.h"
#include "writing/skeleton.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tool
{
namespace
{

// The mesh with smooth borders, in faces that know which of the file they are a piece of.
Segmented_soup soup_of(const Findings& findings, const Polygon_soup& file)
{
  const Smoothed_mesh& smoothed = *findings.smoothed;
  Segmented_soup result;
  result.names = findings.names;
  for (const auto v : vertices(smoothed.mesh))
    result.soup.points.push_back(smoothed.mesh.point(v));
  for (const Face face : faces(smoothed.mesh))
  {
    result.soup.polygons.add(vertices_around_face(smoothed.mesh.halfedge(face), smoothed.mesh));
    result.old_faces.push_back(findings.mesh.face_in_file[smoothed.old_faces[face]]);
  }
  result.segments = smoothed.segment_ids;
  if (!findings.mesh.has_joined_pieces()) // whose surface is not that of the file
    result.soup.attributes = attributes_of_pieces(file, result.soup, result.old_faces);
  return result;
}

std::string note_on_boundary(const Mesh& mesh)
{
  const auto number = std::count_if(halfedges(mesh).begin(), halfedges(mesh).end(),
                                    [&](const auto h) { return is_border(h, mesh); });
  return number == 0 ? "" : "is not closed: meshes of segments stay open along the " + std::to_string(number) +
                              (number == 1 ? " edge" : " edges") + " of its boundary";
}

// Of the files for an output, one for each segment; none if it is a single file.
std::vector<std::string> part_names(const std::string& name, const Output_names& names, const Findings& findings)
{
  const std::size_t number = findings.segmentation.number_of_segments;
  if (names.have_numbers)
    return is_pattern(name) ? names_of_parts(name, number, findings.names) : std::vector<std::string>();
  if (names.folder_of_parts.empty() || !holds_a_mesh(name) || holds_parts(name))
    return {};
  std::vector<std::string> result = names_of_parts("%d" + lower_case_extension(name), number, {});
  for (std::string& part : result)
    part = names.folder_of_parts + "/" + part;
  return result;
}

// Does an output hold closed parts, in one file or several?
bool is_closed(const std::string& name, const Output_names& names, const Findings& findings)
{
  return names.caps != Caps::NONE && (holds_parts(name) || !part_names(name, names, findings).empty());
}

// No material library of the input may be lost, which its name does not tell.
void check_companions(const Output_names& names, const Findings& findings)
{
  for (const std::string& name : names.segments)
    if (const std::string companion = companion_of(name, findings.options.formats);
        !companion.empty() && part_names(name, names, findings).empty()) // parts have none
      for (const std::string& library : findings.mesh.soup.attributes.material_files)
        if (place_of_file(companion) == place_of_file(library))
          throw Error(companion, "is a material library of the input; '" + name + "' would replace it");
}

// Takes the soup of the file, as large as the meshes that are written, and gives it back also if writing fails.
struct Borrowed_soup
{
  explicit Borrowed_soup(Findings& findings)
    : owner(findings.mesh.soup),
      segmented{std::move(findings.mesh.soup), labels_of_file(findings.segmentation.segment_ids, findings.mesh), {}, findings.names}
  {}
  Borrowed_soup(const Borrowed_soup&) = delete;
  Borrowed_soup& operator=(const Borrowed_soup&) = delete;
  ~Borrowed_soup() { owner = std::move(segmented.soup); }

  Polygon_soup& owner;
  Segmented_soup segmented;
};

// `begin(name)` is called before each file.
void write_meshes(Findings& findings,
                  const Output_names& names,
                  const std::function<void(const std::string&)>& begin,
                  Output_files& files)
{
  const Borrowed_soup borrowed(findings);
  const Segmented_soup& segmented = borrowed.segmented;
  if (names.caps == Caps::FLAT || names.caps == Caps::FAIRED)
    findings.add_note(note_on_boundary(findings.mesh.mesh));
  findings.add_note(note_on_single_precision(names.segments, segmented.soup));
  const bool has_parts = std::any_of(names.segments.begin(), names.segments.end(),
                                     [&](const std::string& name)
                                     { return is_closed(name, names, findings); });
  const std::vector<Segmented_soup> closed = has_parts
                                               ? make_closed_parts(findings, segmented.soup, names.caps)
                                               : std::vector<Segmented_soup>();
  const Segmented_soup cut = findings.smoothed ? soup_of(findings, segmented.soup) : Segmented_soup();
  for (const std::string& name : names.segments)
  {
    begin(name);
    const Segmented_soup& whole = findings.smoothed && holds_a_mesh(name) ? cut : segmented;
    const std::vector<std::string> parts = part_names(name, names, findings);
    const Format_options& options = findings.options.formats;
    if (parts.empty() && is_closed(name, names, findings))
      add_output_of_parts(name, closed, files);
    else if (parts.empty())
      add_output(name, whole, options, files);
    else if (names.caps != Caps::NONE)
      add_parts(parts, closed, options, files);
    else
      add_parts(parts, parts_of(whole, findings.segmentation.number_of_segments), options, files);
  }
  if (!names.rig.empty())
  {
    begin(names.rig);
    const Output output = {findings.smoothed ? cut : segmented, findings.options.formats, {}, {}};
    files.add(names.rig, [&](std::ostream& out)
              { write_rig(out, output, find_skeleton(findings), lower_case_extension(names.rig) == ".glb"); });
  }
}

} // namespace

Caps caps_of_name(const std::string& name)
{
  return name.empty() ? Caps::NONE : name == "flat" ? Caps::FLAT : name == "faired" ? Caps::FAIRED : Caps::HULL;
}

void check_can_be_written(const Output_names& names, const Format_options& options)
{
  for (const std::string& name : names.segments)
    if (!is_pattern(name))
    {
      Output_files::check(name);
      if (const std::string companion = companion_of(name, options); !companion.empty())
        Output_files::check(companion);
    }
  for (const std::string& name : {names.json, names.report, names.borders, names.skeleton, names.rig})
    if (!name.empty())
      Output_files::check(name);
}

void write_findings(Findings& findings, const Output_names& names, const Recorder::Progress& progress)
{
  check_companions(names, findings);
  const Clock::time_point start = Clock::now();
  std::size_t number_of_begun = 0;
  const auto begin = [&](const std::string& name)
  {
    const double all = double(names.segments.size() + 5); // that of what may be written besides
    if (progress)
      progress(end_of_segmentation + (1 - end_of_segmentation) * double(number_of_begun++) / all,
               "writing " + name, findings.segmentation.record.protrusions().size());
  };
  Output_files files;
  write_meshes(findings, names, begin, files);
  if (!names.report.empty())
  {
    begin(names.report);
    files.add(names.report, [&](std::ostream& out) { write_report(out, findings); });
  }
  if (!names.borders.empty())
  {
    begin(names.borders);
    files.add(names.borders, [&](std::ostream& out) { write_borders(out, find_borders(findings)); });
  }
  if (!names.skeleton.empty())
  {
    begin(names.skeleton);
    files.add(names.skeleton,
              [&](std::ostream& out) { write_skeleton(out, find_skeleton(findings, inner_joints_of_lines)); });
  }
  findings.seconds_for_writing = seconds_since(start); // the record, which tells of it, is not counted
  if (!names.json.empty())
  {
    begin(names.json);
    files.add(names.json, [&](std::ostream& out) { write_json(out, describe(findings)); });
  }
  files.publish();
}

} // namespace tool
