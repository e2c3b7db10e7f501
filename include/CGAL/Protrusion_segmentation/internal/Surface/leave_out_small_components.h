// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_LEAVE_OUT_SMALL_COMPONENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_LEAVE_OUT_SMALL_COMPONENTS_H

#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_without_small_components.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/small_components.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Finds, among given faces, the one with the nearest centroid.
class Nearest_face
{
public:
  using Index = Indexed_surface::Index;

  Nearest_face(const std::vector<Index>& faces, Scaled_faces& measure)
  {
    for (Index i = 0; i < faces.size(); ++i)
      m_centroids.emplace_back(measure(faces[i]).centroid, i);
    // Where several are as near, the order decides which one is found: one that does not depend on that of the faces.
    std::sort(m_centroids.begin(), m_centroids.end());
    m_tree.insert(m_centroids.begin(), m_centroids.end());
  }

  // The squared distance, and the position in `faces`, with the centroid in front to decide ties.
  using Found = std::tuple<double, Indexed_surface::Point_3, Index>;
  Found operator()(const Indexed_surface::Point_3& point) const
  {
    const Search search(m_tree, point, 1);
    const auto& [centroid, distance] = *search.begin();
    return {distance, centroid.first, centroid.second};
  }

private:
  using Centroid = std::pair<Indexed_surface::Point_3, Index>;
  using Traits = Search_traits_adapter<Centroid,
                                       First_of_pair_property_map<Centroid>,
                                       Search_traits_3<Simple_cartesian<double>>>;
  using Search = Orthogonal_k_neighbor_search<Traits>;

  std::vector<Centroid> m_centroids;
  Search::Tree m_tree;
};

CGAL_PROTRUSION_SEGMENTATION_INLINE Surface_without_small_components
leave_out_small_components(Surface_arrays surface)
{
  using Index = Indexed_surface::Index;
  Surface_without_small_components result;
  const std::vector<Index> component = components_of_faces(surface);
  const std::vector<bool> is_small = small_components(surface, component);
  result.number_of_small_components = std::size_t(std::count(is_small.begin(), is_small.end(), true));
  result.is_connected = is_small.size() == result.number_of_small_components + 1;
  if (result.number_of_small_components == 0)
  {
    result.arrays = std::move(surface);
    return result;
  }
  result.nearest_faces.resize(component.size());
  for (Index f = 0; f < component.size(); ++f)
    if (!is_small[component[f]])
    {
      result.nearest_faces[f] = static_cast<Index>(result.faces.size());
      result.faces.push_back(f);
    }

  Scaled_faces measure(surface);
  const Nearest_face nearest(result.faces, measure);
  const Nearest_face::Found none((std::numeric_limits<double>::infinity)(),
                                 Indexed_surface::Point_3(0, 0, 0), Index(0));
  std::vector<Nearest_face::Found> found(is_small.size(), none); // for every small component
  for (Index f = 0; f < component.size(); ++f)
    if (is_small[component[f]])
      found[component[f]] = (std::min)(found[component[f]], nearest(measure(f).centroid));
  for (Index f = 0; f < component.size(); ++f)
    if (is_small[component[f]])
      result.nearest_faces[f] = std::get<Index>(found[component[f]]);
  result.arrays = Face_selector<Surface_arrays>(surface)(result.faces);
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_LEAVE_OUT_SMALL_COMPONENTS_H
