// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_PYTHON_DISTANCE_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_PYTHON_DISTANCE_H

#include "numpy_arrays.h"

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace python {

namespace PS = CGAL::Protrusion_segmentation;

// An object of Python that threads without the GIL may copy and destroy.
using Shared_object = std::shared_ptr<py::object>;

inline Shared_object share(py::object object)
{
  return Shared_object(new py::object(std::move(object)),
                       [](py::object* shared)
                       {
                         const py::gil_scoped_acquire gil;
                         delete shared;
                       });
}

// A model of ProtrusionDistance by a callable: from the arrays of the face dual graph to a callable from a face to the distances
// of all.
class Python_distance
{
public:
  class On_surface
  {
  public:
    On_surface(Shared_object from_face,
               const PS::Indexed_surface& surface,
               PS::Execution& execution,
               bool is_metric)
      : m_from_face(std::move(from_face)),
        m_surface(surface),
        m_execution(execution),
        m_is_metric(is_metric)
    {}

    void operator()(PS::Indexed_surface::Index source, std::vector<double>& distances)
    {
      const py::gil_scoped_acquire gil;
      const py::object result = (*m_from_face)(source);
      const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(result);
      if (!array)
      {
        PyErr_Clear();
        throw std::invalid_argument("distance: what it gives from a face is no array of numbers");
      }
      distances.assign(array.data(), array.data() + array.size());
    }
    PS::Indexed_surface::Index face_of_largest_sum()
    {
      return m_is_metric ? PS::internal::largest_distance_sum(m_surface, *this, m_execution)
                         : PS::internal::largest_distance_sum_of_all_pairs(m_surface, *this, m_execution);
    }

  private:
    Shared_object m_from_face;
    const PS::Indexed_surface& m_surface;
    PS::Execution& m_execution;
    bool m_is_metric;
  };

  Python_distance(py::object on_graph, bool is_metric)
    : m_on_graph(share(std::move(on_graph))),
      m_is_metric(is_metric)
  {}

  On_surface on(const PS::Indexed_surface& surface, PS::Execution& execution) const
  {
    std::vector<double> centroids, areas, lengths;
    std::vector<std::int64_t> first_arcs(1, 0), neighbors;
    for (PS::Indexed_surface::Index f = 0; f < surface.number_of_faces(); ++f)
    {
      const auto centroid = surface.centroid(f);
      centroids.insert(centroids.end(), {centroid.x(), centroid.y(), centroid.z()});
      areas.push_back(surface.area(f));
      for (auto c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
        if (const auto g = surface.neighbor(c); g != PS::Indexed_surface::no_face())
        {
          neighbors.push_back(g);
          lengths.push_back(surface.arc_length(f, g));
        }
      first_arcs.push_back(static_cast<std::int64_t>(neighbors.size()));
    }
    const py::gil_scoped_acquire gil;
    return On_surface(share((*m_on_graph)(as_points(centroids), as_array(areas), as_array(first_arcs),
                                          as_array(neighbors), as_array(lengths))),
                      surface, execution, m_is_metric);
  }

private:
  Shared_object m_on_graph;
  bool m_is_metric;
};

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_PYTHON_DISTANCE_H
