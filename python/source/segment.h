// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_SEGMENT_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_SEGMENT_H

#include "Chosen_method.h"
#include "Watcher.h"
#include "mesh_of_arrays.h"

#include <CGAL/Protrusion_segmentation/Segment_border.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace python {

// What is asked for.
struct Request
{
  Arrays arrays;
  Method_options method;
  std::optional<std::int64_t> number;            // of segments or tips
  std::string name_of_number;                    // in Python
  std::optional<std::vector<std::int64_t>> tips; // faces given: only their protrusions are cut off
  unsigned int random_seed = 0;
  std::size_t threads = 1;
};

// What is told of a protrusion, and of a body where that makes sense. No number means that there is none.
struct Segment
{
  std::int64_t parent = 0;
  std::int64_t tip = -1;
  double area = 0;
  double protruding_area, border_length, border_distance, value, probability, confidence;
  std::int64_t border_slot = -1;
  std::vector<std::size_t> distance_histogram;
  std::vector<double> sectional_diameter_histogram;
};

struct Border
{
  CGAL::Protrusion_segmentation::Segment_border<tool::Point> line;
  double value, probability;
};

struct Segmentation
{
  std::vector<std::size_t> labels; // of the faces given
  std::vector<Segment> segments;
  std::vector<Border> borders;
  std::vector<std::int64_t> border_edges; // pairs of vertices given
  std::vector<std::int64_t> selected_tips;
  std::size_t number_of_small_components = 0;
  tool::Repairs repairs;
  std::size_t number_of_inside_out_components = 0;
  std::size_t number_of_pieces = 0; // 0 unless they were joined
};

Segmentation segment(const Request& request, Watcher& watcher);

// the faces given at the tips
std::vector<std::size_t> select_tips(const Request& request, Watcher& watcher);

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_SEGMENT_H
