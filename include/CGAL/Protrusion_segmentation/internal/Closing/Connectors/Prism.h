// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_PRISM_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_PRISM_H

#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Cap_frame.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::connectors {

// The corners of a regular polygon at some height. The apothem is the distance of its sides from the axis.
struct Ring
{
  double apothem, height;
};

struct Prism
{
  std::size_t number_of_sides;
  Point_2 center; // in the frame of a cap
  double angle;   // of the first corner
  double radius, depth, chamfer, tolerance;

  double angle_of_side() const { return 2 * CGAL_PI / double(number_of_sides); }

  double radius_of(double apothem_of_polygon) const
  {
    return apothem_of_polygon / std::cos(angle_of_side() / 2);
  }
  double apothem() const { return radius * std::cos(angle_of_side() / 2); }

  std::vector<Point_2> corners(double apothem_of_ring) const
  {
    const double radius_of_ring = radius_of(apothem_of_ring);
    std::vector<Point_2> result;
    for (std::size_t i = 0; i < number_of_sides; ++i)
    {
      const double phi = angle + double(i) * angle_of_side();
      result.emplace_back(center.x() + radius_of_ring * std::cos(phi),
                          center.y() + radius_of_ring * std::sin(phi));
    }
    return result;
  }

  // From the cap to the end, with each plane of the prism moved outwards.
  std::vector<Ring> rings_moved_by(double step) const
  {
    // Where a side and an end, each moved by the step, meet a slope of 45 degrees that is moved by the same.
    const double corner = step * (std::sqrt(2.) - 1);
    std::vector<Ring> rings = {{apothem() + step, 0}};
    if (chamfer > 0)
    {
      rings.push_back({apothem() + step, depth - chamfer + corner});
      rings.push_back({apothem() - chamfer + corner, depth + step});
    }
    else
      rings.push_back({apothem() + step, depth + step});
    return rings;
  }
};

} // namespace CGAL::Protrusion_segmentation::internal::connectors

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_PRISM_H
