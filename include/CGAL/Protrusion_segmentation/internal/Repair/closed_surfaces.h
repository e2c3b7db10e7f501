// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_CLOSED_SURFACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_CLOSED_SURFACES_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Joined_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Radial_order.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// For each polygon: the surface that it belongs to by the points that it names, if that is closed; 1 or 2 for others, by the
// direction of the polygon.
inline std::vector<std::size_t> surfaces_by_points(const Polygon_soup& soup,
                                                   const std::vector<std::size_t>& places)
{
  std::vector<std::size_t> points(soup.points.size());
  std::iota(points.begin(), points.end(), std::size_t(0));
  std::vector<std::size_t> result = clusters_of_polygons(soup.polygons, points);
  std::vector<std::array<std::size_t, 3>> edges; // ends, cluster
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t c = soup.polygons.first_corner(i); c < soup.polygons.first_corner(i + 1); ++c)
    {
      const std::size_t next = c + 1 < soup.polygons.first_corner(i + 1) ? c + 1
                                                                         : soup.polygons.first_corner(i);
      const auto [from, to] = std::minmax({soup.polygons.corner(c), soup.polygons.corner(next)});
      edges.push_back({from, to, result[i]});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<bool> is_closed(points.size(), true);
  for (auto begin = edges.begin(), end = begin; begin != edges.end(); begin = end)
  {
    end = std::find_if(begin, edges.end(), [&](const auto& edge) { return edge != *begin; });
    if (end - begin != 2)
      is_closed[(*begin)[2]] = false;
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = is_closed[result[i]]                                ? result[i] + 3
                : is_reversed(of_corners(places, soup.polygons[i])) ? 2
                                                                    : 1;
  return result;
}

// For each polygon: the closed surface that it is part of, as joined with all polygons, or `open_surface`. A surface that lies
// on another one with all its faces is the same.
inline std::vector<std::size_t> closed_surfaces(const Polygon_soup& soup,
                                                const std::vector<std::size_t>& places,
                                                const Joined_faces& joined)
{
  const std::vector<std::size_t> component = joined.pairs.components();
  std::vector<std::vector<std::size_t>> faces(component.size()); // of each component, by their corners
  for (std::size_t face = 0; face < component.size(); ++face)
    faces[component[face]].push_back(joined.choice.alike[face]);
  for (std::size_t side = 0; side < joined.pairs.number_of_sides(); ++side)
    if (joined.pairs.partner(side) == Edge_pairs::none())
      faces[component[joined.pairs.face(side)]].clear();
  // What is turned against all others around it is no solid, but what encloses them.
  const Polygons& polygons = joined.choice.polygons;
  const std::vector<bool> is_turned = are_inside_out(soup.points, polygons, component, component.size());
  const std::vector<bool> are_all_turned = are_inside_out(
    soup.points, polygons, clusters_of_polygons(polygons, places), soup.points.size());
  for (std::size_t face = 0; face < component.size(); ++face)
    if (is_turned[face] != are_all_turned[face])
      faces[component[face]].clear();

  std::map<std::vector<std::size_t>, std::size_t> numbers = {{{}, open_surface}};
  std::vector<std::size_t> number(component.size(), open_surface); // of each component
  for (std::size_t c = 0; c < faces.size(); ++c)
  {
    std::sort(faces[c].begin(), faces[c].end());
    number[c] = numbers.emplace(std::move(faces[c]), numbers.size()).first->second;
  }
  std::vector<std::size_t> result;
  for (const std::size_t face : joined.choice.label_giver)
    result.push_back(face == Face_choice::none() ? open_surface : number[component[face]]);
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_CLOSED_SURFACES_H
