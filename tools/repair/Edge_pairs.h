// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_REPAIR_EDGE_PAIRS_H
#define PROTRUSION_SEGMENTATION_TOOLS_REPAIR_EDGE_PAIRS_H

#include "repair/Face_choice.h"
#include "repair/Parity_sets.h"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace tool
{

// Which side of a face is joined to which side of another face, so that each side has at most one partner and
// all faces can be oriented alike. Side i of a face goes from its corner i to the next one; the sides of all faces are
// numbered in a row.
//
// Two faces that share an edge with nobody else are joined. First come those that name the same points; then, of
// the sides without partner, those at the same places; last, where more than two sides lie on each other,
// those that go on the most smoothly; a face with a double, as is a wall between two solids, gives way to others
// there. A pair that contradicts the orientation of the pairs before is not joined.
class Edge_pairs
{
public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  Edge_pairs(const std::vector<Point>& points,
             const Face_choice& faces,
             const std::vector<std::size_t>& places);

  std::size_t number_of_sides() const { return m_face.size(); }
  std::size_t number_of_non_manifold_edges() const { return m_number_of_non_manifold_edges; }

  std::size_t first_side(std::size_t face) const { return m_first[face]; }
  std::size_t face(std::size_t side) const { return m_face[side]; }
  std::size_t next(std::size_t side) const
  {
    const std::size_t face = m_face[side];
    return side + 1 < m_first[face + 1] ? side + 1 : m_first[face];
  }
  std::size_t previous(std::size_t side) const
  {
    const std::size_t face = m_face[side];
    return side > m_first[face] ? side - 1 : m_first[face + 1] - 1;
  }

  // `none` if the side lies at the border
  std::size_t partner(std::size_t side) const { return m_partner[side]; }
  void part(std::size_t side);

  // Does the side lie on more than one other?
  bool is_crowded(std::size_t side) const { return m_is_crowded[side]; }

  // Do both sides have the same direction, with the faces as they are in the file?
  bool are_parallel(std::size_t side, std::size_t other) const;

  // For each face: is it turned over, so that all sides go against their partners? As few as possible are.
  std::vector<bool> turned_faces();

  // For each face: its connected component, numbered in no order.
  std::vector<std::size_t> components() const;

private:
  using Ends = std::array<std::size_t, 2>; // of a side, in ascending order; or two sides

  std::size_t start(std::size_t side) const { return m_corner[side]; }
  std::size_t end(std::size_t side) const { return m_corner[next(side)]; }

  template <typename EndsOf>
  std::vector<std::size_t> join_lonely_pairs(const std::vector<std::size_t>& sides, const EndsOf& ends_of);
  void join_smoothest(const std::vector<std::size_t>& sides);
  std::vector<Ends> by_smoothness(const std::vector<std::size_t>& sides) const;
  double smoothness(std::size_t side, std::size_t other) const;
  void join(std::size_t side, std::size_t other);

  const std::vector<Point>& m_points;
  const Face_choice& m_faces;
  const std::vector<std::size_t>& m_places;
  std::vector<std::size_t> m_first;  // side of each face, and the end of all
  std::vector<std::size_t> m_face;   // of each side
  std::vector<std::size_t> m_corner; // of each side: the point where it starts
  std::vector<std::size_t> m_partner;
  std::vector<bool> m_is_crowded;
  Parity_sets m_orientations;
  std::size_t m_number_of_non_manifold_edges = 0;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_REPAIR_EDGE_PAIRS_H
