// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_LEAVE_OUT_COMPONENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_LEAVE_OUT_COMPONENTS_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Edge_pairs.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Parity_sets.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Vertex_fans.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/choose_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/small_components.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// The chosen faces and how they are joined.
struct Joined_faces
{
  Joined_faces(const Polygon_soup& soup,
               const std::vector<std::size_t>& places,
               const std::vector<bool>& is_left_out)
    : choice(choose_faces(soup.polygons, places, is_left_out)),
      pairs(soup.points, choice, places),
      is_turned(pairs.turned_faces()),
      fans(pairs, is_turned)
  {}
  Joined_faces(const Joined_faces&) = delete; // its members refer to each other
  Joined_faces& operator=(const Joined_faces&) = delete;

  Face_choice choice;
  Edge_pairs pairs;
  std::vector<bool> is_turned;
  Vertex_fans fans;
};

// Finds the components that get the labels of their neighbours and no segments of their own: small ones, and walls
// between two solids, all edges of which are shared with two or more other faces. They must touch a component that remains.
class Left_out_components
{
public:
  Left_out_components(const Polygon_soup& soup, const std::vector<std::size_t>& places, const Joined_faces& joined)
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
    Parity_sets clusters(m_places.size());
    for (std::size_t face = 0; face < m_component.size(); ++face)
      for (const std::size_t corner : m_joined.choice.polygons[face])
        clusters.unite(m_places[m_joined.choice.polygons[face].front()], m_places[corner], false);
    const auto cluster_of = [&](std::size_t face)
    { return clusters.find(m_places[m_joined.choice.polygons[face].front()]).first; };
    std::vector<bool> has_more(m_places.size(), false);
    for (std::size_t face = 0; face < m_component.size(); ++face)
      if (!m_is_left_out[m_component[face]])
        has_more[cluster_of(face)] = true;
    for (std::size_t face = 0; face < m_component.size(); ++face)
      if (!has_more[cluster_of(face)])
        m_is_left_out[m_component[face]] = false;
  }

  const Polygon_soup& m_soup;
  const std::vector<std::size_t>& m_places;
  const Joined_faces& m_joined;
  std::vector<std::size_t> m_component; // of each chosen face
  std::vector<bool> m_is_left_out;         // of each component
};

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_LEAVE_OUT_COMPONENTS_H
