// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CAP_FRAME_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CAP_FRAME_H

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::connectors {

using Kernel = Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Point_2 = Kernel::Point_2;

// The plane that fits to a closed polygon, which runs counterclockwise when seen from where z is positive.
class Cap_frame
{
public:
  explicit Cap_frame(const std::vector<Point>& polygon)
  {
    Vector normal(0, 0, 0), sum(0, 0, 0);
    double length = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      normal = normal + CGAL::cross_product(p - polygon[0], q - polygon[0]);
      const double part = std::sqrt((q - p).squared_length());
      sum = sum + part / 2 * ((p - CGAL::ORIGIN) + (q - CGAL::ORIGIN));
      length += part;
    }
    const double size = std::sqrt(normal.squared_length());
    m_is_plane = length > 0 && size > 0;
    if (!m_is_plane)
      return;
    m_origin = CGAL::ORIGIN + sum / length;
    m_z = normal / size;
    const Vector least = std::abs(m_z.x()) <= std::abs(m_z.y()) && std::abs(m_z.x()) <= std::abs(m_z.z())
                           ? Vector(1, 0, 0)
                         : std::abs(m_z.y()) <= std::abs(m_z.z()) ? Vector(0, 1, 0)
                                                                  : Vector(0, 0, 1);
    const Vector across = CGAL::cross_product(least, m_z);
    m_x = across / std::sqrt(across.squared_length());
    m_y = CGAL::cross_product(m_z, m_x);
  }

  // Does the polygon have an area?
  bool is_plane() const { return m_is_plane; }

  Point to_local(const Point& p) const
  {
    const Vector v = p - m_origin;
    return Point(v * m_x, v * m_y, v * m_z);
  }

  Point to_world(const Point& p) const { return m_origin + p.x() * m_x + p.y() * m_y + p.z() * m_z; }

private:
  bool m_is_plane;
  Point m_origin;
  Vector m_x, m_y, m_z;
};

} // namespace CGAL::Protrusion_segmentation::internal::connectors

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CAP_FRAME_H
