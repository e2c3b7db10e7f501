// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions of the package on arrays of numpy. The module around them, in __init__.py, has the documentation,
// and makes arrays of whatever it is given.

#include "choices.h"
#include "mesh_of_arrays.h"
#include "run_interruptibly.h"

#include <CGAL/segmentation_metrics.h>

#include <boost/property_map/property_map.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace python
{
namespace
{

namespace py = pybind11;
using Labels = std::vector<std::size_t>; // of the faces of a mesh or of all faces given
using Count = long long;
using Integers = py::array_t<std::int64_t, py::array::c_style>;
using Coordinates = py::array_t<double, py::array::c_style>;

template <typename T>
std::vector<T> copy(const py::array_t<T, py::array::c_style>& array)
{
  return std::vector<T>(array.data(), array.data() + array.size());
}

// Pieces are joined if there is a gap; with 0 it is that of the package.
Arrays copy(const Coordinates& vertices,
            const Integers& corners,
            const Integers& sizes,
            std::optional<double> snapping_tolerance = std::nullopt,
            std::optional<double> joining_gap = std::nullopt)
{
  const std::optional<double> gap = joining_gap && *joining_gap > 0 ? joining_gap : std::nullopt;
  return {copy(vertices), copy(corners), copy(sizes), snapping_tolerance, joining_gap.has_value(), gap};
}

Integers as_array(const Labels& values)
{
  Integers array(static_cast<py::ssize_t>(values.size()));
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

auto label_map(Labels& labels, const tool::Mesh& mesh)
{
  return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
}

// `patches` are those of the mesh.
auto named_parameters(unsigned int random_seed, Stoppable& visitor, const tool::Mesh& mesh, const Labels& patches)
{
  return CGAL::parameters::random_seed(random_seed)
    .visitor(std::ref(visitor))
    .face_patch_map(boost::make_iterator_property_map(patches.begin(), get(boost::face_index, mesh)));
}

// Of every face that was given, from what `segment(input, map of labels, visitor)` gives to those of the mesh. It must
// own all that it uses.
template <typename Segment>
Integers labels_of_faces(Arrays arrays, Segment segment)
{
  return as_array(run_interruptibly(
    [arrays = std::move(arrays), segment = std::move(segment)](Stoppable& visitor)
    {
      const tool::Input_mesh input = mesh_of_arrays(arrays);
      Labels labels(input.mesh.number_of_faces());
      segment(input, label_map(labels, input.mesh), visitor);
      return tool::labels_of_file(labels, input);
    }));
}

Integers segment(const Coordinates& vertices,
                 const Integers& corners,
                 const Integers& sizes,
                 std::optional<Count> number_of_segments,
                 const std::string& method,
                 const std::optional<std::string>& distance,
                 unsigned int random_seed,
                 std::optional<double> snapping_tolerance,
                 std::optional<double> joining_gap)
{
  return labels_of_faces(
    copy(vertices, corners, sizes, snapping_tolerance, joining_gap),
    [=](const tool::Input_mesh& input, auto labels, Stoppable& visitor)
    {
      const Labels patches = tool::patches_of_mesh(input);
      const auto np = named_parameters(random_seed, visitor, input.mesh, patches);
      with_method(method, distance,
                  [&](const auto& m)
                  {
                    return number_of_segments
                             ? CGAL::segmentation_via_protrusion_tips(input.mesh, labels, *number_of_segments, m, np)
                             : CGAL::segmentation_via_protrusion_tips(input.mesh, labels, m, np);
                  });
    });
}

// A face that is not in the mesh has a tip where it has its label from.
std::vector<tool::Face> faces_at(const std::vector<std::int64_t>& tips, const tool::Input_mesh& input)
{
  std::vector<tool::Face> faces;
  for (const std::int64_t tip : tips)
  {
    if (tip < 0 || static_cast<std::size_t>(tip) >= input.label_giver.size())
      throw std::invalid_argument("tips: a face is not in the mesh");
    faces.emplace_back(static_cast<tool::Mesh::size_type>(input.label_giver[static_cast<std::size_t>(tip)]));
  }
  return faces;
}

Integers segment_from_tips(const Coordinates& vertices,
                           const Integers& corners,
                           const Integers& sizes,
                           const std::vector<std::int64_t>& tips,
                           const std::string& method,
                           const std::optional<std::string>& distance,
                           unsigned int random_seed,
                           std::optional<double> snapping_tolerance,
                           std::optional<double> joining_gap)
{
  return labels_of_faces(
    copy(vertices, corners, sizes, snapping_tolerance, joining_gap),
    [=](const tool::Input_mesh& input, auto labels, Stoppable& visitor)
    {
      const std::vector<tool::Face> faces = faces_at(tips, input);
      const Labels patches = tool::patches_of_mesh(input);
      const auto np = named_parameters(random_seed, visitor, input.mesh, patches);
      with_method(method, distance, [&](const auto& m)
                  { return CGAL::segmentation_from_protrusion_tips(input.mesh, faces, labels, m, np); });
    });
}

// The labels for the largest number of segments, and the parents of the segments.
std::pair<Integers, Integers> hierarchy(const Coordinates& vertices,
                                        const Integers& corners,
                                        const Integers& sizes,
                                        Count maximum_number_of_segments,
                                        const std::string& method,
                                        const std::optional<std::string>& distance,
                                        unsigned int random_seed,
                                        std::optional<double> snapping_tolerance,
                                        std::optional<double> joining_gap)
{
  const auto [labels, parents] = run_interruptibly(
    [=, arrays = copy(vertices, corners, sizes, snapping_tolerance, joining_gap)](Stoppable& visitor)
    {
      const tool::Input_mesh input = mesh_of_arrays(arrays);
      const Labels patches = tool::patches_of_mesh(input);
      const auto np = named_parameters(random_seed, visitor, input.mesh, patches);
      const PS::Segment_hierarchy found =
        with_method(method, distance, [&](const auto& m)
                    { return CGAL::protrusion_hierarchy(input.mesh, maximum_number_of_segments, m, np); });
      const std::size_t number_of_segments = found.maximum_number_of_segments();
      Labels labels(input.mesh.number_of_faces());
      found.segment_ids(input.mesh, number_of_segments, label_map(labels, input.mesh));
      Labels parents;
      for (std::size_t s = 0; s < number_of_segments; ++s)
        parents.push_back(found.parent(s));
      return std::make_pair(tool::labels_of_file(labels, input), parents);
    });
  return {as_array(labels), as_array(parents)};
}

Integers tips(const Coordinates& vertices,
              const Integers& corners,
              const Integers& sizes,
              Count number_of_tips,
              const std::string& distance,
              unsigned int random_seed,
              std::optional<double> snapping_tolerance,
              std::optional<double> joining_gap)
{
  return as_array(run_interruptibly(
    [=, arrays = copy(vertices, corners, sizes, snapping_tolerance, joining_gap)](Stoppable& visitor)
    {
      const tool::Input_mesh input = mesh_of_arrays(arrays);
      const Labels patches = tool::patches_of_mesh(input);
      std::vector<tool::Face> found;
      with_distance(distance,
                    [&](const auto& d)
                    {
                      return CGAL::protrusion_tips(input.mesh, number_of_tips, std::back_inserter(found), d,
                                                   named_parameters(random_seed, visitor, input.mesh, patches));
                    });
      Labels faces;
      for (const tool::Face face : found)
        faces.push_back(input.face_in_file[face]);
      return faces;
    }));
}

std::vector<std::int64_t> labels_of_mesh(const std::vector<std::int64_t>& labels,
                                         const tool::Input_mesh& input,
                                         const std::string& name)
{
  if (labels.size() != input.label_giver.size())
    throw std::invalid_argument(name + ": there are " + std::to_string(labels.size()) + ", but the mesh has " +
                                std::to_string(input.label_giver.size()) + " faces");
  std::vector<std::int64_t> result;
  for (const std::size_t face : input.face_in_file)
    result.push_back(labels[face]);
  return result;
}

// In the order of the fields of `Metrics` in __init__.py.
py::tuple evaluate(const Coordinates& vertices,
                   const Integers& corners,
                   const Integers& sizes,
                   const Integers& labels,
                   const Integers& reference)
{
  const PS::Segmentation_metrics metrics = run_interruptibly(
    [arrays = copy(vertices, corners, sizes), labels_of_all = copy(labels), reference_of_all = copy(reference)](
      Stoppable&)
    {
      const tool::Input_mesh input = mesh_of_arrays(arrays);
      const std::vector<std::int64_t> ids = labels_of_mesh(labels_of_all, input, "labels");
      const std::vector<std::int64_t> reference_ids = labels_of_mesh(reference_of_all, input, "reference");
      const auto face_index = get(boost::face_index, input.mesh);
      return CGAL::Protrusion_segmentation::segmentation_metrics(
        input.mesh, boost::make_iterator_property_map(ids.begin(), face_index),
        boost::make_iterator_property_map(reference_ids.begin(), face_index));
    });
  const auto& hamming = metrics.hamming_distance;
  const auto& consistency = metrics.consistency_error;
  return py::make_tuple(metrics.rand_index_error, hamming.distance, hamming.missing_rate, hamming.false_alarm_rate,
                        metrics.cut_discrepancy, consistency.global, consistency.local, consistency.global_by_area,
                        consistency.local_by_area, metrics.mean_best_intersection_over_union);
}

// A `ValueError` with the names of the arguments in Python: what is `pmesh` in C++ is given as vertices and faces.
void translate_invalid_argument(std::exception_ptr exception)
{
  try
  {
    if (exception)
      std::rethrow_exception(exception);
  }
  catch (const std::invalid_argument& error)
  {
    std::string message = error.what();
    const std::string name = "pmesh";
    if (const std::size_t place = message.find(name); place != std::string::npos)
      message.replace(place, name.size(), "the mesh");
    PyErr_SetString(PyExc_ValueError, message.c_str());
  }
}

} // namespace
} // namespace python

PYBIND11_MODULE(_core, module)
{
  module.attr("version") = PROTRUSION_SEGMENTATION_VERSION;
  python::py::register_local_exception_translator(&python::translate_invalid_argument);
  module.def("segment", &python::segment);
  module.def("segment_from_tips", &python::segment_from_tips);
  module.def("hierarchy", &python::hierarchy);
  module.def("tips", &python::tips);
  module.def("evaluate", &python::evaluate);
  using python::py::cpp_function;
  python::py::module_::import("atexit").attr("register")(cpp_function([]() { python::calls().end(); }));
  const python::py::module_ os = python::py::module_::import("os");
  if (hasattr(os, "register_at_fork"))
    os.attr("register_at_fork")(python::py::arg("after_in_child") = cpp_function(
                                  []()
                                  {
                                    python::calls().forget();
                                    python::interrupted_threads().forget();
                                  }));
}
