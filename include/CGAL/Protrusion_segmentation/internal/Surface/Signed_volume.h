// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SIGNED_VOLUME_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SIGNED_VOLUME_H

#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <optional>

namespace CGAL::Protrusion_segmentation::internal {

// The signed volume of a closed surface, of which the corners of all faces are added.
class Signed_volume
{
public:
  template <typename Corners>
  void add(const Corners& corners)
  {
    if (!m_origin)
      m_origin = corners[0];
    const double v = (corners[0] - *m_origin) * polygon_area_vector(corners) / 3;
    m_volume += v;
    m_sum += std::abs(v);
  }

  // 1 if the faces look outward, -1 if inward, 0 if there is no volume.
  int orientation() const
  {
    // Of what is summed. Rounding gives less, as for surfaces of which each face is there both ways.
    constexpr double least_share = 1e-6;
    return std::abs(m_volume) <= least_share * m_sum ? 0 : m_volume > 0 ? 1 : -1;
  }

  double volume() const { return m_volume; }

private:
  std::optional<Simple_cartesian<double>::Point_3> m_origin;
  double m_volume = 0, m_sum = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SIGNED_VOLUME_H
