// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/json.h"

#include "writing/Json_object.h"

#include <cstddef>
#include <vector>

namespace tool {

Json describe(const Segmentation_options& options)
{
  Json_object object;
  object
    .add_if(options.number_of_segments.has_value(), "segments_requested",
            options.number_of_segments.value_or(0))
    .add_optional("hierarchy_requested", options.hierarchy)
    .add_if(options.tips.has_value(), "tips_requested", options.tips.value_or(std::vector<std::size_t>()))
    .add_if(!options.labels.empty(), "labels", options.labels)
    .add_if(options.labels.empty(), "method", options.method)
    .add_if(!options.distance.empty(), "distance", options.distance) // none: the method's own
    .add_if(options.distance == "landmark", "landmarks", options.landmarks)
    .add_if(options.distance == "diffusion", "eigenpairs", options.eigenpairs)
    .add_if(options.distance == "diffusion", "diffusion_time", options.time)
    .add("seed", options.seed)
    .add("smooth_borders", options.are_borders_smooth)
    .add("join_pieces", options.are_pieces_joined)
    .add_if(options.gap.has_value(), "gap", options.gap.value_or(0))
    .add_if(options.weld_distance.has_value(), "weld_distance", options.weld_distance.value_or(0))
    .add_if(!options.caps.empty(), "caps", options.caps)
    .add_if(options.connectors.has_value(), "connectors_requested",
            options.connectors ? describe(*options.connectors) : Json())
    .add("triangulate", options.formats.are_faces_triangulated)
    .add("one_object", options.formats.is_one_object)
    .add("colors", options.formats.are_colors_of_input ? "input" : "segments")
    .add("up", options.formats.up)
    .add("array_name", options.formats.array_name);
  return object.take();
}

} // namespace tool
