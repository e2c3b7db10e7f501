// SPDX-License-Identifier: GPL-3.0-or-later
//
// What segment_by_protrusions computes: a segmentation by a method and a distance that are chosen
// by name, with all that a visitor is told on the way.

#ifndef CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_SEGMENT_H
#define CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_SEGMENT_H

#include "../include/tool_support.h"
#include "Recorder.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tool
{

struct Segmentation_options
{
  std::optional<std::size_t> number_of_segments; // unset: as many as there are evident protrusions
  std::string method = "minimum-cut"; // the package's own default
  std::string distance = "geodesic";
  std::string landmarks = "5%"; // a share of the faces, or a number of them
  std::size_t eigenpairs =
      CGAL::Protrusion_segmentation::Diffusion_distance::default_number_of_eigenpairs();
  double time = CGAL::Protrusion_segmentation::Diffusion_distance::default_time();
  unsigned int seed = 0;
};

struct Segmentation
{
  std::vector<std::size_t> segment_ids; // in the order of the faces
  std::size_t number_of_segments = 0;
  double seconds = 0; // without reading and writing files
  Recorder record;
};

// What can be chosen by name. `options` are the command line options that have a meaning only with
// this choice.
struct Choice
{
  std::string name;
  std::string description;
  std::vector<std::string> options;
};
std::vector<Choice> methods();
std::vector<Choice> distances();

// Throws std::invalid_argument if an option has a value that makes no sense.
void check_options(const Segmentation_options& options);

Segmentation
segment(const Mesh& mesh, const Segmentation_options& options, const Recorder::Progress& progress);

} // namespace tool

#endif // CGAL_EXAMPLES_PROTRUSION_SEGMENTATION_TOOL_SEGMENT_H
