// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small components: connected components so small beside the largest one that they are noise, as dust of a scanner. They
// get no segments of their own, and all others are segmented as if there were none.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SMALL_COMPONENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SMALL_COMPONENTS_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A small component has less of the area of the largest component, and fewer faces than that: less than half of the least
// protrusion, which has .0025 of its component. A figure on a large floor of few faces is not small.
constexpr double area_share_of_small_component = 0.001;

// For every component whether it is small.
inline std::vector<bool> small_components(const std::vector<double>& areas,
                                          const std::vector<std::size_t>& face_counts)
{
  const std::size_t largest = std::size_t(std::max_element(areas.begin(), areas.end()) - areas.begin());
  std::vector<bool> result;
  for (std::size_t c = 0; c < areas.size(); ++c)
    result.push_back(areas[c] < area_share_of_small_component * areas[largest] &&
                     face_counts[c] < face_counts[largest]);
  return result;
}

// The same for the components of a surface, by the component of every face. Coordinates are at most 1.
inline std::vector<bool> small_components(const Surface_arrays& surface,
                                          const std::vector<Indexed_surface::Index>& components,
                                          std::size_t number_of_components)
{
  std::vector<double> areas(number_of_components, 0);
  std::vector<std::size_t> face_counts(number_of_components, 0);
  for (Indexed_surface::Index f = 0; f < surface.number_of_faces(); ++f)
  {
    areas[components[f]] += measure_polygon(Corners_of_face<Surface_arrays>{surface, f}).area;
    ++face_counts[components[f]];
  }
  return small_components(areas, face_counts);
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SMALL_COMPONENTS_H
