// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_REQUEST_OF_ARGUMENTS_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_REQUEST_OF_ARGUMENTS_H

#include "Python_distance.h"
#include "numpy_arrays.h"
#include "segment.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace python {

// A mesh as Python passes it: coordinates, corners of all faces, their numbers of corners.
struct Mesh_arguments
{
  Coordinates vertices;
  Integers corners, sizes;
};

// The value of an option that is there, or of type `T` by default.
template <typename T>
T option(const py::dict& options, const char* name)
{
  return options.contains(name) ? options[name].cast<T>() : T();
}

inline Arrays arrays_of_arguments(const Mesh_arguments& mesh, const py::dict& options)
{
  Arrays arrays;
  arrays.coordinates = copy(mesh.vertices);
  arrays.corners = copy(mesh.corners);
  arrays.sizes = copy(mesh.sizes);
  arrays.snapping_tolerance = option<std::optional<double>>(options, "snapping_tolerance");
  arrays.are_pieces_joined = option<bool>(options, "are_pieces_joined");
  arrays.gap = option<std::optional<double>>(options, "gap");
  return arrays;
}

// The names are those of the fields, the values are sound: __init__.py makes them.
inline Request request_of_arguments(const Mesh_arguments& mesh, const py::dict& options)
{
  Request request;
  request.arrays = arrays_of_arguments(mesh, options);
  request.number = option<std::optional<std::int64_t>>(options, "number");
  request.name_of_number = option<std::string>(options, "name_of_number");
  request.tips = option<std::optional<std::vector<std::int64_t>>>(options, "tips");
  request.random_seed = option<unsigned int>(options, "random_seed");
  request.threads = option<std::size_t>(options, "threads");
  Method_options& method = request.method;
  method.method = option<std::string>(options, "method");
  method.distance = option<std::string>(options, "distance");
  method.share_of_landmarks = option<std::optional<double>>(options, "share_of_landmarks");
  method.number_of_landmarks = option<std::optional<std::size_t>>(options, "number_of_landmarks");
  method.number_of_terms = option<std::size_t>(options, "number_of_terms");
  method.time = option<double>(options, "time");
  method.minimum_prominence = option<double>(options, "minimum_prominence");
  method.uses_candidate_intervals = option<bool>(options, "uses_candidate_intervals");
  if (options.contains("own_distance"))
    method.own_distance = Chosen_distance(PS::internal::Any_distance(
      Python_distance(options["own_distance"], option<bool>(options, "is_metric"))));
  return request;
}

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_REQUEST_OF_ARGUMENTS_H
