// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_JOINED_FACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_JOINED_FACES_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Edge_pairs.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Parity_sets.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/choose_faces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The corners of faces that become one vertex: those that meet where sides are joined. A vertex so has one fan of
// faces around it, whatever the soup says.
class Vertex_fans
{
public:
  Vertex_fans(Edge_pairs& pairs, const std::vector<bool>& is_turned)
    : m_pairs(pairs),
      m_is_turned(is_turned)
  {
    do
      unite_corners();
    while (part_conflicts());
  }

  // where the side starts in the soup
  std::size_t vertex_at(std::size_t side) const { return m_vertex[side]; }

private:
  void unite_corners()
  {
    Parity_sets sets(m_pairs.number_of_sides());
    for (std::size_t side = 0; side < m_pairs.number_of_sides(); ++side)
      if (const std::size_t other = m_pairs.partner(side); other != Edge_pairs::none() && side < other)
      {
        const bool is_parallel = m_pairs.are_parallel(side, other);
        sets.unite(side, is_parallel ? other : m_pairs.next(other), false);
        sets.unite(m_pairs.next(side), is_parallel ? m_pairs.next(other) : other, false);
      }
    m_vertex.resize(m_pairs.number_of_sides());
    for (std::size_t side = 0; side < m_vertex.size(); ++side)
      m_vertex[side] = sets.find(side).first;
  }

  // No mesh has a face with a vertex twice, or two faces on the same side of an edge. Where it comes to that, one
  // corner is taken out of its fan.
  bool part_conflicts()
  {
    const std::vector<std::size_t> corners = corners_in_conflict();
    for (const std::size_t side : corners)
    {
      m_pairs.part(side);
      m_pairs.part(m_pairs.previous(side));
    }
    return !corners.empty();
  }

  std::vector<std::size_t> corners_in_conflict() const
  {
    // What may be there once only: a face with a vertex, and an edge with a direction.
    std::vector<std::array<std::size_t, 3>> corners, edges;
    for (std::size_t side = 0; side < m_vertex.size(); ++side)
    {
      const std::size_t from = m_vertex[side], to = m_vertex[m_pairs.next(side)];
      const bool is_turned = m_is_turned[m_pairs.face(side)];
      corners.push_back({m_pairs.face(side), from, side});
      edges.push_back({is_turned ? to : from, is_turned ? from : to, side});
    }
    std::vector<std::size_t> result;
    for (auto* list : {&corners, &edges})
    {
      std::sort(list->begin(), list->end());
      for (std::size_t i = 1; i < list->size(); ++i)
        if ((*list)[i][0] == (*list)[i - 1][0] && (*list)[i][1] == (*list)[i - 1][1])
          result.push_back((*list)[i][2]);
    }
    return result;
  }

  Edge_pairs& m_pairs;
  const std::vector<bool>& m_is_turned;
  std::vector<std::size_t> m_vertex;
};

// The chosen faces and how they are joined.
struct Joined_faces
{
  Joined_faces(const Polygon_soup& soup,
               const std::vector<std::size_t>& places,
               const std::vector<std::size_t>& surfaces,
               const std::vector<bool>& is_left_out)
    : choice(Face_chooser(soup.polygons, places, surfaces, is_left_out).choose()),
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

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_JOINED_FACES_H
