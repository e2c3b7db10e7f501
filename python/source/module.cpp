// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

//
// The module _core: functions on arrays of numpy. The Python files have the documentation, check arguments, and make objects of what
// is found.

#include "compare.h"
#include "parts.h"
#include "request_of_arguments.h"
#include "results.h"
#include "run_interruptibly.h"
#include "smooth.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace python {
namespace {

// `function(request, watcher)`, in a thread of its own unless it calls functions of Python.
template <typename Function>
auto run(const Mesh_arguments& mesh, const py::dict& options, Function function)
{
  auto compute = [request = request_of_arguments(mesh, options), function](Watcher& watcher)
  { return function(request, watcher); };
  const py::object progress = option<py::object>(options, "progress");
  const bool is_told = progress && !progress.is_none();
  if (!is_told && !options.contains("own_distance"))
    return run_interruptibly(std::move(compute));
  const std::function<void(double)> tell = [&progress](double share)
  {
    const py::gil_scoped_acquire gil;
    progress(share);
  };
  return run_with_callbacks(std::move(compute), is_told ? tell : nullptr);
}

py::dict call_segment(const Coordinates& vertices,
                      const Integers& corners,
                      const Integers& sizes,
                      const py::dict& options)
{
  return as_dict(run({vertices, corners, sizes}, options, &segment));
}

py::object call_tips(const Coordinates& vertices,
                     const Integers& corners,
                     const Integers& sizes,
                     const py::dict& options)
{
  return as_array(run({vertices, corners, sizes}, options, &select_tips));
}

py::dict call_smooth(const Coordinates& vertices,
                     const Integers& corners,
                     const Integers& sizes,
                     const py::dict& options,
                     const Integers& labels,
                     unsigned int number_of_iterations)
{
  return as_dict(run_interruptibly([arrays = arrays_of_arguments({vertices, corners, sizes}, options),
                                    labels = copy(labels), number_of_iterations](Watcher&)
                                   { return smooth(arrays, labels, number_of_iterations); }));
}

Tree_of_arrays copy_tree(const Integers& labels, const Integers& parents, const Integers& tips)
{
  return {copy(labels), copy(parents), copy(tips)};
}

// What Python calls with a mesh, its segments and one thing more: `function(arrays, tree, option)`.
template <typename Option, typename Function>
auto function_of_segments(Function function)
{
  return [function](const Coordinates& vertices, const Integers& corners, const Integers& sizes,
                    const py::dict& options, const Integers& labels, const Integers& parents,
                    const Integers& tips, const Option& option)
  {
    return as_python(run_interruptibly(
      [arrays = arrays_of_arguments({vertices, corners, sizes}, options),
       tree = copy_tree(labels, parents, tips), function, option](Watcher&)
      { return function(arrays, tree, option); }));
  };
}

std::vector<Part> close(const Arrays& arrays, const Tree_of_arrays& tree, bool are_caps_faired)
{
  return are_caps_faired ? close_segments_by_faired_caps(arrays, tree) : close_segments(arrays, tree);
}

// In the order of the fields of `Connector_options`.
using Connector_numbers =
  std::tuple<std::size_t, double, double, double, std::optional<double>, std::optional<double>>;

Connected_parts connect(const Arrays& arrays, const Tree_of_arrays& tree, const Connector_numbers& numbers)
{
  const auto& [sides, radius, depth, chamfer, tolerance, smallest_radius] = numbers;
  return close_segments_with_connectors(arrays, tree,
                                        {sides, radius, depth, chamfer, tolerance, smallest_radius});
}

py::list call_compare(const Coordinates& vertices,
                      const Integers& corners,
                      const Integers& sizes,
                      const Integers& labels,
                      const std::vector<std::vector<std::int64_t>>& references,
                      const std::string& metrics)
{
  return as_list(run_interruptibly([arrays = arrays_of_arguments({vertices, corners, sizes}, py::dict()),
                                    labels = copy(labels), references, metrics](Watcher&)
                                   { return compare(arrays, labels, references, metrics); }));
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
  module.def("segment", &python::call_segment);
  module.def("tips", &python::call_tips);
  module.def("smooth_borders", &python::call_smooth);
  module.def("closed_segments", python::function_of_segments<bool>(&python::close));
  module.def("closed_segments_with_connectors",
             python::function_of_segments<python::Connector_numbers>(&python::connect));
  module.def("skeleton", python::function_of_segments<int>(&python::find_skeleton));
  module.def("evaluate", &python::call_compare);
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
