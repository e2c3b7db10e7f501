// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/segment_file.h"

#include "command_line/Error.h"
#include "reading/read_labels.h"
#include "reading/read_mesh.h"
#include "segmentation/given_segmentation.h"
#include "segmentation/segment.h"
#include "segmentation/smooth_borders.h"
#include "segmentation/timing.h"
#include "segmentation/touching_components.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace tool
{
namespace
{

// From there on a warning comes first: exact distances take minutes, and so does that many eigenpairs.
constexpr std::size_t many_faces_for_exact_distances = 5000;
constexpr std::size_t many_eigenpairs = 100;

// Empty, or why the number of segments is not the one asked for, or is one.
std::string note_on_number(const Segmentation_options& options, const Segmentation& segmentation)
{
  const std::size_t found = segmentation.number_of_segments;
  const std::size_t wanted = options.number_of_segments.value_or(found);
  std::ostringstream note;
  if (found < wanted)
    note << "found " << found << " of " << wanted << " segments: no further border was found";
  else if (found > wanted)
    note << "found " << found << " segments instead of " << wanted << ": each of the mesh's " << found
         << " connected components is at least one";
  else if (found == 1 && !options.number_of_segments && !options.tips && options.labels.empty())
    note << "found no protrusion; -k N asks for a number of segments";
  return note.str();
}

// The last segments of a large number are cut off where nothing is.
std::string note_on_guessed_borders(const Segmentation_options& options, const Segmentation& segmentation)
{
  const auto& protrusions = segmentation.record.protrusions();
  const auto number = std::count_if(protrusions.begin(), protrusions.end(),
                                    [](const Protrusion& protrusion) { return protrusion.value < 0; });
  if (number == 0 || !options.number_of_segments)
    return "";
  return std::to_string(number) + (number == 1 ? " segment was" : " segments were") +
         " cut off where the shape shows no border, to reach the number asked for";
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

// Faces of the file as faces of the mesh.
std::optional<std::vector<std::size_t>> tips_on_mesh(const Findings& findings)
{
  if (!findings.options.tips)
    return std::nullopt;
  std::vector<std::size_t> tips;
  for (const std::size_t tip : *findings.options.tips)
  {
    if (tip >= findings.mesh.label_giver.size())
      throw Error(findings.input, "has no face " + std::to_string(tip) + ", which --tips names: it has " +
                                    std::to_string(findings.mesh.label_giver.size()) + " faces");
    tips.push_back(findings.mesh.label_giver[tip]);
  }
  return tips;
}

// Labels may be any numbers; segments are numbered from 0.
std::string note_on_new_numbers(const std::vector<std::size_t>& labels, const Segmentation& segmentation)
{
  const std::size_t last = *std::max_element(labels.begin(), labels.end());
  return last < segmentation.number_of_segments
           ? ""
           : "the labels of the file, up to " + std::to_string(last) + ", are numbered from 0 to " +
               std::to_string(segmentation.number_of_segments - 1) + " in their order";
}

void take_labels(Findings& findings)
{
  const std::vector<std::size_t> labels = read_labels(findings.options.labels, findings.mesh);
  findings.segmentation = given_segmentation(findings.mesh.mesh, labels);
  findings.add_note(note_on_new_numbers(labels, findings.segmentation));
}

// A tip has a protrusion if it lies in one that no tip before it has.
std::string note_on_tips(const Findings& findings)
{
  std::set<std::size_t> free;
  for (const Protrusion& protrusion : findings.segmentation.record.protrusions())
    free.insert(protrusion.segment);
  std::string faces;
  std::size_t number = 0;
  for (const std::size_t tip : findings.options.tips.value_or(std::vector<std::size_t>()))
    if (free.erase(findings.segmentation.segment_ids[findings.mesh.label_giver[tip]]) == 0)
      faces += (number++ == 0 ? " " : ", ") + std::to_string(tip);
  return number == 0 ? "" : "found no border for the " + std::string(number == 1 ? "tip at face" : "tips at faces") + faces;
}

std::string note_on_small_components(const Findings& findings)
{
  const std::size_t number = findings.segmentation.record.number_of_small_components();
  return number == 0 ? "" : std::to_string(number) + (number == 1 ? " small component has" : " small components have") +
                              " the label of the nearest segment";
}

std::string note_on_pieces(const Findings& findings)
{
  if (findings.options.are_pieces_joined || findings.mesh.repairs.components < 2)
    return "";
  const auto [touching, all] = touching_components(findings.mesh.mesh);
  return touching == 0 ? "" : std::to_string(touching) + " of " + std::to_string(all) +
                              " components touch each other; --join-pieces makes one shape of them";
}

void smooth(Findings& findings)
{
  Segmentation& segmentation = findings.segmentation;
  findings.smoothed = smooth_borders(findings.mesh.mesh, segmentation.segment_ids);
  segmentation.segment_ids =
    segments_of_old_faces(*findings.smoothed, segmentation.segment_ids.size(), segmentation.number_of_segments);
}

std::string note_on_borders(const Findings& findings)
{
  const std::size_t number = findings.smoothed ? findings.smoothed->number_of_fixed_segments : 0;
  return number == 0 ? "" : std::to_string(number) + (number == 1 ? " segment is" : " segments are") +
                              " too thin for smooth borders";
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
  const auto tell = [progress](double share, const std::string& stage, std::size_t protrusions)
  {
    if (progress)
      progress(share, stage, protrusions);
  };
  tell(0, "reading the file", 0);
  findings.mesh = options.are_pieces_joined ? read_joined_pieces(input, options.gap)
                                            : read_input_mesh(input, options.weld_distance);
  findings.seconds_for_file = seconds_since(start);
  const std::size_t faces = findings.mesh.mesh.number_of_faces();
  const std::size_t wanted = options.hierarchy.value_or(options.number_of_segments.value_or(0));
  if (wanted > faces)
    throw Error(input, "has " + std::to_string(faces) + " faces, too few for " + std::to_string(wanted) +
                         " segments");
  warn_of_time(findings, warn);
  Segmentation_options options_on_mesh = options;
  options_on_mesh.tips = tips_on_mesh(findings);
  if (!options.labels.empty())
    take_labels(findings);
  else
    findings.segmentation =
      segment(findings.mesh.mesh, patches_of_mesh(findings.mesh), options_on_mesh,
              [tell](double share, const std::string& stage, std::size_t protrusions)
              {
                tell(begin_of_segmentation + share * (end_of_segmentation - begin_of_segmentation), stage, protrusions);
              });
  if (options.are_borders_smooth)
  {
    tell(end_of_segmentation, "smoothing borders", findings.segmentation.record.protrusions().size());
    smooth(findings);
  }
  for (const std::string& note :
       {describe_repairs(findings.mesh), note_on_small_components(findings), note_on_pieces(findings),
        note_on_number(options, findings.segmentation), note_on_guessed_borders(options, findings.segmentation),
        note_on_tips(findings), note_on_borders(findings)})
    findings.add_note(note);
  return findings;
}

std::string note_on_missing_segments(const Findings& findings)
{
  const std::size_t found = findings.segmentation.number_of_segments;
  return found < findings.options.number_of_segments.value_or(0)
           ? note_on_number(findings.options, findings.segmentation)
           : "";
}

std::string summary(const Findings& findings)
{
  std::ostringstream line;
  const std::size_t faces = findings.mesh.label_giver.size(), segments = findings.segmentation.number_of_segments;
  line << faces << (faces == 1 ? " face, " : " faces, ") << segments << (segments == 1 ? " segment, " : " segments, ")
       << std::fixed << std::setprecision(3) << findings.seconds() << " s";
  return line.str();
}

} // namespace tool
