// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Methods and distances by their names, which are those of the command line tool.

#ifndef PROTRUSION_SEGMENTATION_PYTHON_SOURCE_CHOICES_H
#define PROTRUSION_SEGMENTATION_PYTHON_SOURCE_CHOICES_H

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/Exact_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Heat_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/protrusion_segmentation.h>

#include <optional>
#include <stdexcept>
#include <string>

namespace python
{

namespace PS = CGAL::Protrusion_segmentation;

// The result of `function(distance)`.
template <typename Function>
auto with_distance(const std::string& name, const Function& function)
{
  if (name == "geodesic")
    return function(PS::Geodesic_distance());
  if (name == "landmark")
    return function(PS::Landmark_geodesic_distance());
  if (name == "diffusion")
    return function(PS::Diffusion_distance());
  if (name == "heat")
    return function(PS::Heat_distance());
  if (name == "exact")
    return function(PS::Exact_geodesic_distance());
  throw std::invalid_argument("distance is '" + name +
                              "', but it must be geodesic, landmark, diffusion, heat or exact");
}

template <typename Method>
Method make_method(const std::optional<std::string>& distance)
{
  return distance ? with_distance(*distance, [](const auto& d) { return Method(d); }) : Method();
}

// The result of `function(method)`; without a distance the method has its own.
template <typename Function>
auto with_method(const std::string& name, const std::optional<std::string>& distance, const Function& function)
{
  if (name == "minimum-cut")
    return function(make_method<PS::Minimum_cut_method>(distance));
  if (name == "paper")
    return function(make_method<PS::Histogram_method>(distance));
  throw std::invalid_argument("method is '" + name + "', but it must be minimum-cut or paper");
}

} // namespace python

#endif // PROTRUSION_SEGMENTATION_PYTHON_SOURCE_CHOICES_H
