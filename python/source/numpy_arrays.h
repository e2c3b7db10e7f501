// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_NUMPY_ARRAYS_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_NUMPY_ARRAYS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace python {

namespace py = pybind11;
using Integers = py::array_t<std::int64_t, py::array::c_style>;
using Coordinates = py::array_t<double, py::array::c_style>;

template <typename T>
std::vector<T> copy(const py::array_t<T, py::array::c_style>& array)
{
  return std::vector<T>(array.data(), array.data() + array.size());
}

// Integers become `int64`.
template <typename T>
auto as_array(const std::vector<T>& values)
{
  using Value = std::conditional_t<std::is_integral_v<T>, std::int64_t, double>;
  py::array_t<Value> array(static_cast<py::ssize_t>(values.size()));
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

// in rows of `width`
template <typename T>
auto as_rows(const std::vector<T>& values, std::size_t width)
{
  const auto columns = static_cast<py::ssize_t>(width);
  return as_array(values).reshape(
    {width == 0 ? 0 : static_cast<py::ssize_t>(values.size()) / columns, columns});
}

inline auto as_points(const std::vector<double>& coordinates)
{
  return as_rows(coordinates, 3);
}

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_NUMPY_ARRAYS_H
