// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_PARTS_WITH_CONNECTORS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_PARTS_WITH_CONNECTORS_H

#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Connector_placer.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/parts_with_flat_caps.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

inline void check_range(const char* name, double value, double least, double most)
{
  if (!(value >= least && value <= most))
    throw std::invalid_argument(std::string("connectors: ") + name + " is out of range");
}

inline void check_connector_options(const Connector_options& options)
{
  constexpr double smallest = (std::numeric_limits<double>::min)(),
                   largest = (std::numeric_limits<double>::max)();
  if (options.number_of_sides < least_number_of_sides || options.number_of_sides > most_sides)
    throw std::invalid_argument("connectors: number_of_sides is " +
                                std::to_string(options.number_of_sides) +
                                ", but it must be from " + std::to_string(least_number_of_sides) + " to " +
                                std::to_string(most_sides));
  check_range("radius", options.radius, smallest, std::nextafter(1., 0.));
  check_range("depth", options.depth, smallest, largest);
  check_range("chamfer", options.chamfer, 0, 0.5);
  check_range("tolerance", options.tolerance.value_or(0), 0, largest);
  check_range("smallest_radius", options.smallest_radius.value_or(0), 0, largest);
}

struct Parts_with_connectors
{
  Parts_with_flat_caps parts;
  std::vector<Connector<Mesh_to_close::Point>> connectors; // of each cap
};

// Computes with points that are scaled by a power of two, so that squares neither overflow nor vanish.
inline Parts_with_connectors parts_with_connectors(const Mesh_to_close& mesh,
                                                   const std::vector<std::size_t>& segment_of_face,
                                                   const std::vector<std::size_t>& parents,
                                                   const Connector_options& options)
{
  check_connector_options(options);
  Capper capper(mesh);
  std::vector<Flat_cap> caps = flat_caps(mesh, segment_of_face, parents, capper);
  std::vector<Mesh_to_close::Point> points = capper.points(), scaled = points;
  if (caps.empty())
    return {parts_with_caps(mesh, segment_of_face, parents.size(), caps, points), {}};
  const int exponent = scale_to_unit(scaled);
  connectors::Connector_placer placer(mesh, segment_of_face, capper, options, std::ldexp(1., -exponent),
                                      scaled);
  std::vector<Connector<Mesh_to_close::Point>> placed = placer.place(caps);
  for (std::size_t v = points.size(); v < scaled.size(); ++v)
    points.push_back(scaled_by_power_of_two(scaled[v], exponent));
  for (Connector<Mesh_to_close::Point>& connector : placed)
  {
    connector.base = scaled_by_power_of_two(connector.base, exponent);
    connector.end = scaled_by_power_of_two(connector.end, exponent);
    for (double* length :
         {&connector.cap_radius, &connector.radius, &connector.depth, &connector.tolerance})
      *length = std::ldexp(*length, exponent);
  }
  return {parts_with_caps(mesh, segment_of_face, parents.size(), caps, points), placed};
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_PARTS_WITH_CONNECTORS_H
