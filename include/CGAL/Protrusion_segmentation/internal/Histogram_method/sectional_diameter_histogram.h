// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_SECTIONAL_DIAMETER_HISTOGRAM_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_SECTIONAL_DIAMETER_HISTOGRAM_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/distance_histogram.h>
#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_index.h>
#include <CGAL/Protrusion_segmentation/internal/Histogram_method/plane_section.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The plane through the ring of faces in a slot: through the ring's centre of gravity, normal to the
// direction in which the distance grows there (the gradient over all arcs that leave a face of the ring).
inline Section_plane plane_of_slot(const Indexed_surface& surface,
                                   const std::vector<double>& distances,
                                   const Slots& slots,
                                   std::size_t slot)
{
  using Index = Indexed_surface::Index;
  using Vector_3 = Indexed_surface::Vector_3;
  Vector_3 centre(0, 0, 0), growth(0, 0, 0);
  double area = 0;
  const Indexed_surface::Point_3 origin(0, 0, 0);
  for (Index f : slots.faces(slot))
  {
    const Indexed_surface::Point_3 centroid = surface.centroid(f);
    area += surface.area(f);
    centre += surface.area(f) * (centroid - origin);
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      if (const Index g = surface.neighbor(c); g != Indexed_surface::no_face())
      {
        const Vector_3 arc = surface.centroid(g) - centroid;
        const double length = std::sqrt(arc.squared_length()); // as in the dual graph
        if (length > 0)
          growth += (surface.area(f) * (distances[g] - distances[f]) / (length * length)) * arc;
      }
  }
  return {area > 0 ? origin + centre / area : surface.centroid(slots.faces(slot).front()), growth};
}

// The diameter of the component of the section that lies nearest to the centre of the ring; 0 if the plane
// crosses no face of the ring.
inline double diameter_of_slot(const Section_plane& plane,
                               const Slots& slots,
                               std::size_t slot,
                               Plane_section& section)
{
  std::vector<Indexed_surface::Point_3> points, nearest_points;
  double nearest = (std::numeric_limits<double>::infinity)();
  section.start();
  for (Indexed_surface::Index f : slots.faces(slot))
  {
    points.clear();
    section.component(f, plane, points);
    double distance = (std::numeric_limits<double>::infinity)();
    for (const Indexed_surface::Point_3& p : points)
      distance = (std::min)(distance, squared_distance(p, plane.origin));
    if (distance < nearest)
    {
      nearest = distance;
      nearest_points.swap(points);
    }
  }
  return planar_diameter(nearest_points, plane.normal);
}

// The sectional-diameter histogram of Section III.D.2: for each slot of the distance histogram the diameter
// of the surface's section there, in the unit of `surface`. A slot without a section takes the diameter of the
// slot before it. Slots that are not in `slots` get 0.
inline std::array<double, number_of_slots> sectional_diameter_histogram(
  const Indexed_surface& surface,
  const std::vector<double>& distances,
  const Slots& slots,
  Plane_section& section,
  Execution& execution)
{
  std::array<double, number_of_slots> diameters{};
  for_each_index(
    slots.number(), execution.is_parallel(), section,
    [&](Plane_section& section_of_thread, std::size_t s)
    {
      execution.check();
      if (!slots.faces(s).empty())
        diameters[s] = diameter_of_slot(plane_of_slot(surface, distances, slots, s), slots, s,
                                        section_of_thread);
    },
    [](const Plane_section&) {});
  for (std::size_t s = 1; s < slots.number(); ++s)
    if (diameters[s] == 0)
      diameters[s] = diameters[s - 1];
  return diameters;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_SECTIONAL_DIAMETER_HISTOGRAM_H
