// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_LEAVE_OUT_SMALL_COMPONENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_LEAVE_OUT_SMALL_COMPONENTS_H

#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_without_small_components.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/connected_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/extract_segment.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/nested_components.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/small_components.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Finds the nearest of given faces: of those with the nearest centroids, which are all of a small surface.
class Nearest_face
{
public:
  using Index = Indexed_surface::Index;

  // Coordinates are at most 1. `surface` must outlive the object.
  template <typename Faces>
  Nearest_face(const Surface_arrays& surface, const Faces& faces) : m_surface(surface)
  {
    for (const Index f : faces)
      m_centroids.emplace_back(centroid_of_face(surface, f), f);
    // Where several are as near, the order decides which one is found: one that does not depend on that of the faces.
    std::sort(m_centroids.begin(), m_centroids.end());
    m_tree.insert(m_centroids.begin(), m_centroids.end());
  }

  // The squared distance, and the face, with the centroid in front to decide ties.
  using Found = std::tuple<double, Indexed_surface::Point_3, Index>;
  Found operator()(const Indexed_surface::Point_3& point) const
  {
    constexpr unsigned int number_of_centroids = 16;
    Found found((std::numeric_limits<double>::infinity)(), point, Index(0));
    for (const auto& [centroid, distance] : Search(m_tree, point, number_of_centroids))
      found = (std::min)(found, Found(squared_distance_to(centroid.second, point), centroid.first, centroid.second));
    return found;
  }

private:
  using Centroid = std::pair<Indexed_surface::Point_3, Index>;
  using Traits = Search_traits_adapter<Centroid,
                                       First_of_pair_property_map<Centroid>,
                                       Search_traits_3<Simple_cartesian<double>>>;
  using Search = Orthogonal_k_neighbor_search<Traits>;

  double squared_distance_to(Index face, const Indexed_surface::Point_3& point) const
  {
    double result = (std::numeric_limits<double>::infinity)();
    for_each_triangle_of_fan(Corners_of_face<Surface_arrays>{m_surface, face},
                             [&](const auto& p, const auto& q, const auto& r)
                             {
                               const Simple_cartesian<double>::Triangle_3 triangle(p, q, r);
                               result = (std::min)(result, CGAL::squared_distance(point, triangle));
                             });
    return result;
  }

  const Surface_arrays& m_surface;
  std::vector<Centroid> m_centroids;
  Search::Tree m_tree;
};

// For each component: that whose cavity it is the wall of, or itself. Neither of both is small.
inline std::vector<Indexed_surface::Index> walls_of_cavities(const Nested_components& nested,
                                                             const std::vector<bool>& is_small)
{
  std::vector<Indexed_surface::Index> result = nested.walls();
  for (Indexed_surface::Index c = 0; c < result.size(); ++c)
    if (is_small[result[c]] || is_small[c])
      result[c] = c;
  return result;
}

// Sets, for the faces of the walls of cavities, the nearest of the faces around.
inline void find_nearest_faces_of_cavities(const Nested_components& nested,
                                           const std::vector<Indexed_surface::Index>& walls,
                                           const Surface_arrays& surface,
                                           std::vector<Indexed_surface::Index>& nearest_faces)
{
  using Index = Indexed_surface::Index;
  std::map<Index, std::vector<Index>> cavities; // in each component that has some
  for (Index c = 0; c < walls.size(); ++c)
    if (walls[c] != c)
      cavities[walls[c]].push_back(c);
  for (const auto& [around, walls_in_it] : cavities)
  {
    const Nearest_face nearest(surface, nested.faces(around));
    for (const Index wall : walls_in_it)
      for (const Index f : nested.faces(wall))
        nearest_faces[f] = nearest_faces[std::get<Index>(nearest(centroid_of_face(surface, f)))];
  }
}

// Sets, for the faces of small components, the face that is nearest to the component.
inline void find_nearest_faces_of_small_components(const std::vector<Indexed_surface::Index>& component,
                                                   const std::vector<bool>& is_small,
                                                   const std::vector<Indexed_surface::Index>& faces,
                                                   const Surface_arrays& surface,
                                                   std::vector<Indexed_surface::Index>& nearest_faces)
{
  using Index = Indexed_surface::Index;
  const Nearest_face nearest(surface, faces);
  const Nearest_face::Found none((std::numeric_limits<double>::infinity)(),
                                 Indexed_surface::Point_3(0, 0, 0), Index(0));
  std::vector<Nearest_face::Found> found(is_small.size(), none); // for every small component
  for (Index f = 0; f < component.size(); ++f)
    if (is_small[component[f]])
      found[component[f]] = (std::min)(found[component[f]], nearest(centroid_of_face(surface, f)));
  for (Index f = 0; f < component.size(); ++f)
    if (is_small[component[f]])
      nearest_faces[f] = nearest_faces[std::get<Index>(found[component[f]])];
}

CGAL_PROTRUSION_SEGMENTATION_INLINE Surface_without_small_components
leave_out_small_components(Surface_arrays surface)
{
  using Index = Indexed_surface::Index;
  Surface_without_small_components result;
  const std::vector<Index> component = components_of_faces(surface);
  const std::size_t number = component.empty()
                               ? 0
                               : *std::max_element(component.begin(), component.end()) + std::size_t(1);
  result.is_connected = number == 1;
  if (number < 2)
  {
    result.arrays = std::move(surface);
    return result;
  }
  const int exponent = scale_to_unit(surface.points);
  const std::vector<bool> is_small = small_components(surface, component, number);
  const auto scale_back = [exponent](Surface_arrays arrays)
  {
    for (Indexed_surface::Point_3& p : arrays.points)
      p = scaled_by_power_of_two(p, exponent);
    return arrays;
  };
  const Nested_components nested(surface, component, number);
  const std::vector<Index> walls = walls_of_cavities(nested, is_small);
  std::size_t number_left = 0;
  for (Index c = 0; c < number; ++c)
    number_left += !is_small[c] && walls[c] == c ? 1 : 0;
  result.number_of_small_components = std::size_t(std::count(is_small.begin(), is_small.end(), true));
  result.is_connected = number_left == 1;
  if (number_left == number)
  {
    result.arrays = scale_back(std::move(surface));
    return result;
  }
  result.nearest_faces.resize(component.size());
  for (Index f = 0; f < component.size(); ++f)
    if (const Index c = component[f]; !is_small[c] && walls[c] == c)
    {
      result.nearest_faces[f] = static_cast<Index>(result.faces.size());
      result.faces.push_back(f);
    }
  find_nearest_faces_of_cavities(nested, walls, surface, result.nearest_faces);
  if (result.number_of_small_components > 0)
    find_nearest_faces_of_small_components(component, is_small, result.faces, surface,
                                           result.nearest_faces);
  result.arrays = scale_back(Face_selector<Surface_arrays>(surface)(result.faces));
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_LEAVE_OUT_SMALL_COMPONENTS_H
