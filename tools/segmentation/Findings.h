// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is asked of segment_by_protrusions, and what it finds.

#ifndef PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_FINDINGS_H
#define PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_FINDINGS_H

#include "repair/Input_mesh.h"
#include "segmentation/Recorder.h"
#include "segmentation/smooth_borders.h"
#include "writing/Format_options.h"

#include <CGAL/Protrusion_segmentation/Connector.h>
#include <CGAL/Protrusion_segmentation/Connector_options.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tool
{

// Those of the package, whose header takes long to compile.
std::size_t default_number_of_eigenpairs();
double default_diffusion_time();

struct Segmentation_options
{
  std::optional<std::size_t> number_of_segments; // unset: as many as there are protrusions
  std::optional<std::size_t> hierarchy; // the number of segments of a hierarchy of which that many are taken
  std::string method = "minimum-cut"; // the package's own default
  std::string distance; // empty: that of the method
  std::string landmarks = "5%"; // a share of the faces, or a number of them
  std::size_t eigenpairs = default_number_of_eigenpairs();
  double time = default_diffusion_time();
  unsigned int seed = 0;
  std::optional<std::vector<std::size_t>> tips; // faces of the file: only their protrusions are cut off
  std::string labels; // a file with the segments; empty: they are to be found
  bool are_borders_smooth = false;
  bool are_pieces_joined = false;
  std::optional<double> gap; // up to which pieces are joined; unset: a share of the size
  std::optional<double> weld_distance; // up to which corners on borders are one; unset: as the numbers tell
  std::string caps; // of a collection: what closes the parts, "flat" or "faired"; empty: there are none
  std::optional<CGAL::Protrusion_segmentation::Connector_options> connectors; // of parts with flat caps; unset: there are none
  Format_options formats; // of what is written
  std::size_t threads = 1; // no matter for the result
};

using Connector = CGAL::Protrusion_segmentation::Connector<Point>;

struct Segmentation
{
  std::vector<std::size_t> segment_ids; // of the faces of the mesh
  std::size_t number_of_segments = 0;
  double seconds = 0;
  Recorder record;
};

// All that is told of a run of segment_by_protrusions.
struct Findings
{
  std::string input;
  Segmentation_options options;
  Input_mesh mesh;
  double seconds_for_file = 0; // to read it and to make a surface of it
  Segmentation segmentation;
  std::optional<Smoothed_mesh> smoothed; // of the mesh, if that was asked for
  std::vector<std::string> names; // of the segments, empty for those without; or none at all
  std::string note; // empty, or why there are not as many segments as were asked for

  std::vector<std::string> formats; // of the segments of a collection, which are known by their names alone

  // Of each cap; unset if there were none to be put on.
  std::optional<std::vector<Connector>> connectors;

  // Unset until the segments and the report are written.
  std::optional<double> seconds_for_writing;

  // with smooth borders, if there are
  const Mesh& mesh_of_borders() const { return smoothed ? smoothed->mesh : mesh.mesh; }
  const std::vector<std::size_t>& segments_at_borders() const
  {
    return smoothed ? smoothed->segment_ids : segmentation.segment_ids;
  }

  void add_note(const std::string& more) { note += (note.empty() || more.empty() ? "" : "; ") + more; }

  double seconds() const { return seconds_for_file + segmentation.seconds; }
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_SEGMENTATION_FINDINGS_H
