// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_MANIFOLD_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_MANIFOLD_SURFACE_H

#include <CGAL/Protrusion_segmentation/Polygon_soup_repairs.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Edge_pairs.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Joined_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Radial_order.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/closed_surfaces.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/label_by_neighbors.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/sew_borders.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/small_components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Adds walls between two solids: components of faces that are there twice, at each open edge of which there are two or more
// other faces.
inline void add_walls(const Joined_faces& joined,
                      const std::vector<std::size_t>& component,
                      std::vector<bool>& is_chosen)
{
  std::vector<bool> is_wall(component.size(), true), has_border(component.size(), false);
  for (std::size_t side = 0; side < joined.pairs.number_of_sides(); ++side)
  {
    const std::size_t face = joined.pairs.face(side);
    const bool is_open = joined.pairs.partner(side) == Edge_pairs::none();
    if (is_open)
      has_border[component[face]] = true;
    if (!joined.choice.has_duplicate[face] || (is_open && !joined.pairs.is_non_manifold(side)))
      is_wall[component[face]] = false;
  }
  for (std::size_t c = 0; c < component.size(); ++c)
    is_chosen[c] = is_chosen[c] || (is_wall[c] && has_border[c]);
}

// Leaves out components that get the labels of their neighbours and no segments of their own: small ones and walls that touch
// a component that remains. Sets their polygons; returns the number of components.
inline std::size_t leave_out_components(const Polygon_soup& soup,
                                        const std::vector<std::size_t>& places,
                                        const Joined_faces& joined,
                                        std::vector<bool>& is_left_out)
{
  const Polygons& polygons = joined.choice.polygons;
  const std::vector<std::size_t> component = joined.pairs.components();
  std::vector<double> area(component.size(), 0);
  std::vector<std::size_t> count(component.size(), 0);
  for (std::size_t face = 0; face < component.size(); ++face)
  {
    area[component[face]] += std::sqrt(area_vector(soup.points, polygons[face]).squared_length());
    ++count[component[face]];
  }
  std::vector<bool> is_chosen = small_components(area, count);
  add_walls(joined, component, is_chosen);

  const std::vector<std::size_t> cluster = clusters_of_polygons(polygons, places);
  std::vector<bool> has_more(places.size(), false);
  for (std::size_t face = 0; face < component.size(); ++face)
    if (!is_chosen[component[face]])
      has_more[cluster[face]] = true;
  std::size_t number = 0;
  for (std::size_t face = 0; face < component.size(); ++face)
    if (is_chosen[component[face]] && has_more[cluster[face]])
    {
      is_left_out[joined.choice.kept[face]] = true;
      number += component[face] == face ? 1u : 0u; // a component is named after one of its faces
    }
  return number;
}

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

// With all polygons that may be walls between closed surfaces, and no others that are duplicates.
inline std::unique_ptr<Joined_faces> join_with_walls(const Polygon_soup& soup,
                                                     const std::vector<std::size_t>& places)
{
  const std::vector<bool> none_left_out(soup.polygons.size(), false);
  const std::vector<std::size_t> open_surfaces(soup.polygons.size(), open_surface);
  auto result = std::make_unique<Joined_faces>(soup, places, open_surfaces, none_left_out);
  if (result->choice.duplicate_polygons > 0)
    result = std::make_unique<Joined_faces>(soup, places, surfaces_by_points(soup, places),
                                            none_left_out);
  return result;
}

// The same without duplicates; `surfaces` becomes that of each polygon.
inline std::unique_ptr<Joined_faces> without_duplicates(const Polygon_soup& soup,
                                                        const std::vector<std::size_t>& places,
                                                        std::unique_ptr<Joined_faces> joined,
                                                        std::vector<std::size_t>& surfaces)
{
  const std::size_t number = soup.polygons.size();
  const std::vector<bool>& has_duplicate = joined->choice.has_duplicate;
  surfaces.assign(number, open_surface);
  if (std::find(has_duplicate.begin(), has_duplicate.end(), true) == has_duplicate.end())
    return joined;
  surfaces = closed_surfaces(soup, places, *joined);
  return std::make_unique<Joined_faces>(soup, places, surfaces, std::vector<bool>(number, false));
}

// Joins what the polygons of a soup are, and sews borders up to the tolerance.
inline std::unique_ptr<Joined_faces> join_and_sew(Polygon_soup& soup,
                                                  double tolerance,
                                                  std::vector<std::size_t>& places,
                                                  std::vector<std::size_t>& surfaces,
                                                  Polygon_soup_repairs& repairs)
{
  auto joined = join_with_walls(soup, places);
  // What was joined to something else before may be a border now.
  while (const std::size_t number = tolerance > 0
                                      ? Border_sewer(soup, places, *joined, tolerance).join_corners()
                                      : 0)
  {
    repairs.joined_corners += number;
    joined = join_with_walls(soup, places);
  }
  joined = without_duplicates(soup, places, std::move(joined), surfaces);
  if (tolerance > 0)
    repairs.split_edges = Border_sewer(soup, places, *joined, tolerance).split_sides();
  if (repairs.split_edges > 0)
    joined = without_duplicates(soup, places, join_with_walls(soup, places), surfaces);
  return joined;
}

// The polygons by their corners, so that results do not depend on their order; those with the same corners stay in it.
inline std::vector<std::size_t> order_by_corners(const Polygons& polygons,
                                                 const std::vector<std::size_t>& places)
{
  std::vector<std::pair<std::vector<std::size_t>, std::size_t>> order;
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    order.emplace_back(of_corners(places, polygons[i]), i);
    std::sort(order.back().first.begin(), order.back().first.end());
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> result;
  for (const auto& [corners, i] : order)
    result.push_back(i);
  return result;
}

// Of polygons in an order that their corners alone decide. Polygons that are no faces get none, unless they are duplicates.
// `place_of` becomes the place of each point.
inline Manifold_surface surface_of_ordered(Polygon_soup soup,
                                           std::optional<double> tolerance,
                                           std::vector<std::size_t>& place_of)
{
  Manifold_surface surface;
  Polygon_soup_repairs& repairs = surface.repairs;
  std::vector<std::size_t> surfaces;
  const int exponent = scale_to_unit(soup);
  const double scaled_tolerance = tolerance ? std::ldexp(*tolerance, -exponent)
                                            : automatic_tolerance(of_corners(soup.points, soup.polygons.corners()));
  auto joined = join_and_sew(soup, scaled_tolerance, place_of, surfaces, repairs);
  std::vector<bool> is_left_out(soup.polygons.size(), false);
  repairs.degenerate_polygons = joined->choice.degenerate_polygons;
  repairs.duplicate_polygons = joined->choice.duplicate_polygons;
  repairs.non_manifold_edges = joined->pairs.number_of_non_manifold_edges();
  repairs.small_components = leave_out_components(soup, place_of, *joined, is_left_out);
  if (repairs.small_components > 0) // then the rest is joined anew
    joined = std::make_unique<Joined_faces>(soup, place_of, surfaces, is_left_out);
  repairs.unorientable_edges = joined->pairs.number_of_unorientable_edges();
  repairs.reversed_polygons = std::size_t(
    std::count(joined->is_turned.begin(), joined->is_turned.end(), true));
  repairs.components = number_of_components(joined->pairs);
  number_vertices(*joined, surface);
  surface.polygon_of_face = std::move(joined->choice.kept);
  surface.face_of_polygon = std::move(joined->choice.label_giver);
  return surface;
}

// Coordinates are finite and corners are points. Throws if no polygon has three different corners. Corners that are no farther
// from each other than the tolerance are one, at borders; an automatic one if none is given.
inline Manifold_surface manifold_surface(const Polygon_soup& soup,
                                         std::optional<double> tolerance = std::nullopt)
{
  std::vector<std::size_t> place_of = places(soup.points);
  const std::vector<std::size_t> order = order_by_corners(soup.polygons, place_of);
  Polygon_soup ordered = {soup.points, {}};
  for (const std::size_t i : order)
    ordered.polygons.add(soup.polygons[i]);
  const Manifold_surface found = surface_of_ordered(std::move(ordered), tolerance, place_of);
  // back to the order of the polygons
  std::vector<std::pair<std::size_t, std::size_t>> faces; // polygon, face
  for (std::size_t f = 0; f < found.faces.size(); ++f)
    faces.emplace_back(order[found.polygon_of_face[f]], f);
  std::sort(faces.begin(), faces.end());
  Manifold_surface result;
  result.point_of_vertex = found.point_of_vertex;
  result.repairs = found.repairs;
  std::vector<std::size_t> new_face(faces.size());
  for (const auto& [polygon, f] : faces)
  {
    new_face[f] = result.faces.size();
    result.faces.add(found.faces[f]);
    result.polygon_of_face.push_back(polygon);
  }
  result.face_of_polygon.resize(order.size(), Face_choice::none());
  for (std::size_t i = 0; i < order.size(); ++i)
    if (const std::size_t f = found.face_of_polygon[i]; f != Face_choice::none())
      result.face_of_polygon[order[i]] = new_face[f];
  label_by_neighbors(soup.polygons, place_of, result.polygon_of_face, result.face_of_polygon);
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_MANIFOLD_SURFACE_H
