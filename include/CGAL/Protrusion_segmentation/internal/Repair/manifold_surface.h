// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_MANIFOLD_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_MANIFOLD_SURFACE_H

#include <CGAL/Protrusion_segmentation/Polygon_soup_repairs.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/leave_out_components.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The faces of a surface that any mesh type can hold, and how they belong to the polygons of a soup.
struct Manifold_surface
{
  Polygons faces;                           // their corners are vertices
  std::vector<std::size_t> point_of_vertex; // ascending; a point may be that of several vertices
  std::vector<std::size_t> polygon_of_face; // ascending
  std::vector<std::size_t> face_of_polygon; // that labels it
  Polygon_soup_repairs repairs;
};

// The vertices are in the order of their points, the faces in that of their polygons.
inline void number_vertices(const Joined_faces& joined, Manifold_surface& surface)
{
  const Polygons& polygons = joined.choice.polygons;
  std::vector<std::array<std::size_t, 3>> corners; // point, vertex, corner
  for (std::size_t corner = 0; corner < polygons.number_of_corners(); ++corner)
    corners.push_back({polygons.corner(corner), joined.fans.vertex_at(corner), corner});
  std::sort(corners.begin(), corners.end());

  std::vector<std::size_t> number(corners.size(), Edge_pairs::none());
  for (const auto& [point, vertex, corner] : corners)
    if (number[vertex] == Edge_pairs::none())
    {
      number[vertex] = surface.point_of_vertex.size();
      surface.point_of_vertex.push_back(point);
    }
  std::vector<std::size_t> face;
  for (std::size_t f = 0; f < polygons.size(); ++f)
  {
    face.clear();
    for (std::size_t corner = polygons.first_corner(f); corner < polygons.first_corner(f + 1); ++corner)
      face.push_back(number[joined.fans.vertex_at(corner)]);
    if (joined.is_turned[f])
      std::reverse(face.begin() + 1, face.end());
    surface.faces.add(face);
  }
}

inline std::size_t number_of_components(const Edge_pairs& pairs)
{
  const std::vector<std::size_t> component = pairs.components();
  std::size_t count = 0;
  for (std::size_t face = 0; face < component.size(); ++face)
    count += component[face] == face ? 1u : 0u; // it is named after one of its faces
  return count;
}

// Coordinates are finite and corners are points. Throws if no polygon has three different corners.
inline Manifold_surface manifold_surface(Polygon_soup soup)
{
  Manifold_surface surface;
  const std::vector<std::size_t> place_of = places(soup.points);
  scale_to_unit(soup);
  std::vector<bool> is_left_out(soup.polygons.size(), false);
  auto joined = std::make_unique<Joined_faces>(soup, place_of, is_left_out);
  Polygon_soup_repairs& repairs = surface.repairs;
  repairs.degenerate_polygons = joined->choice.degenerate_polygons;
  repairs.duplicate_polygons = joined->choice.duplicate_polygons;
  repairs.non_manifold_edges = joined->pairs.number_of_non_manifold_edges();
  repairs.specks = Left_out_components(soup, place_of, *joined).leave_out(is_left_out);
  if (repairs.specks > 0) // then the rest is joined anew
    joined = std::make_unique<Joined_faces>(soup, place_of, is_left_out);
  repairs.unorientable_edges = joined->pairs.number_of_unorientable_edges();
  repairs.reversed_polygons =
    std::size_t(std::count(joined->is_turned.begin(), joined->is_turned.end(), true));
  repairs.components = number_of_components(joined->pairs);
  number_vertices(*joined, surface);
  surface.polygon_of_face = std::move(joined->choice.kept);
  surface.face_of_polygon = std::move(joined->choice.label_giver);
  return surface;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_MANIFOLD_SURFACE_H
