// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_MANIFOLD_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_MANIFOLD_SURFACE_H

#include <CGAL/Protrusion_segmentation/Polygon_soup_repairs.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Edge_pairs.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Joined_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Neighbor_labels.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Radial_order.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/closed_surfaces.h>
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

// Finds the components that get the labels of their neighbours and no segments of their own: small ones, and walls
// between two solids, all edges of which are shared with two or more other faces. They must touch a component that remains.
class Left_out_components
{
public:
  Left_out_components(const Polygon_soup& soup,
                      const std::vector<std::size_t>& places,
                      const Joined_faces& joined)
    : m_soup(soup),
      m_places(places),
      m_joined(joined),
      m_component(joined.pairs.components()),
      m_is_left_out(m_component.size(), false)
  {
    find_small_ones();
    find_walls();
    keep_isolated_ones();
  }

  // Sets their faces, by their numbers in the soup; returns the number of components.
  std::size_t leave_out(std::vector<bool>& is_left_out) const
  {
    std::size_t count = 0;
    for (std::size_t face = 0; face < m_component.size(); ++face)
      if (m_is_left_out[m_component[face]])
      {
        is_left_out[m_joined.choice.kept[face]] = true;
        count += m_component[face] == face ? 1u : 0u; // a component is named after one of its faces
      }
    return count;
  }

private:
  void find_small_ones()
  {
    std::vector<double> area(m_component.size(), 0);
    std::vector<std::size_t> count(m_component.size(), 0);
    for (std::size_t face = 0; face < area.size(); ++face)
    {
      area[m_component[face]] += std::sqrt(
        area_vector(m_soup.points, m_joined.choice.polygons[face]).squared_length());
      ++count[m_component[face]];
    }
    m_is_left_out = small_components(area, count);
  }

  void find_walls()
  {
    const Edge_pairs& pairs = m_joined.pairs;
    std::vector<bool> is_wall(m_component.size(), true);
    for (std::size_t side = 0; side < pairs.number_of_sides(); ++side)
    {
      const std::size_t face = pairs.face(side);
      const bool is_free = pairs.partner(side) == Edge_pairs::none() && !pairs.is_non_manifold(side);
      if (!m_joined.choice.has_duplicate[face] || is_free)
        is_wall[m_component[face]] = false;
    }
    std::vector<bool> has_border(m_component.size(), false);
    for (std::size_t side = 0; side < pairs.number_of_sides(); ++side)
      if (pairs.partner(side) == Edge_pairs::none())
        has_border[m_component[pairs.face(side)]] = true;
    for (std::size_t face = 0; face < m_component.size(); ++face)
      m_is_left_out[face] = m_is_left_out[face] || (is_wall[face] && has_border[face]);
  }

  // Those that touch nothing but others that are left out, or nothing at all.
  void keep_isolated_ones()
  {
    const std::vector<std::size_t> cluster = clusters_of_polygons(m_joined.choice.polygons, m_places);
    std::vector<bool> has_more(m_places.size(), false);
    for (std::size_t face = 0; face < m_component.size(); ++face)
      if (!m_is_left_out[m_component[face]])
        has_more[cluster[face]] = true;
    for (std::size_t face = 0; face < m_component.size(); ++face)
      if (!has_more[cluster[face]])
        m_is_left_out[m_component[face]] = false;
  }

  const Polygon_soup& m_soup;
  const std::vector<std::size_t>& m_places;
  const Joined_faces& m_joined;
  std::vector<std::size_t> m_component; // of each chosen face
  std::vector<bool> m_is_left_out;      // of each component
};

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

// The points that are corners.
inline std::vector<Polygon_soup::Point_3> corners_of(const Polygon_soup& soup)
{
  std::vector<Polygon_soup::Point_3> result;
  for (std::size_t c = 0; c < soup.polygons.number_of_corners(); ++c)
    result.push_back(soup.points[soup.polygons.corner(c)]);
  return result;
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
inline std::vector<std::size_t> order_by_corners(const Polygon_soup& soup)
{
  const std::vector<std::size_t> place_of = places(soup.points);
  std::vector<std::pair<std::vector<std::size_t>, std::size_t>> polygons;
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    polygons.emplace_back(places_of(soup.polygons[i], place_of), i);
    std::sort(polygons.back().first.begin(), polygons.back().first.end());
  }
  std::sort(polygons.begin(), polygons.end());
  std::vector<std::size_t> result;
  for (const auto& [corners, i] : polygons)
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
  auto joined = join_and_sew(
    soup, tolerance ? std::ldexp(*tolerance, -exponent) : automatic_tolerance(corners_of(soup)), place_of,
    surfaces, repairs);
  std::vector<bool> is_left_out(soup.polygons.size(), false);
  repairs.degenerate_polygons = joined->choice.degenerate_polygons;
  repairs.duplicate_polygons = joined->choice.duplicate_polygons;
  repairs.non_manifold_edges = joined->pairs.number_of_non_manifold_edges();
  repairs.small_components = Left_out_components(soup, place_of, *joined).leave_out(is_left_out);
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
  const std::vector<std::size_t> order = order_by_corners(soup);
  Polygon_soup ordered = {soup.points, {}};
  for (const std::size_t i : order)
    ordered.polygons.add(soup.polygons[i]);
  std::vector<std::size_t> place_of = places(soup.points);
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
  Neighbor_labels(soup.polygons, place_of, result.polygon_of_face).complete(result.face_of_polygon);
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_MANIFOLD_SURFACE_H
