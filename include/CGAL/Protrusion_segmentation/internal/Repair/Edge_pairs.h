// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_EDGE_PAIRS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_EDGE_PAIRS_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Parity_sets.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Radial_order.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/choose_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Which side of a face is joined to which side of another face, so that each side has at most one partner and
// all faces can be oriented alike. A side goes from a corner of its face to the next one, and has the number of that
// corner.
//
// Two faces that share an edge with no other face are joined. Sides with the same points come first; then, of the
// sides without partner, those at the same places; last, at non-manifold edges, those between which a solid lies, or, if
// the orientations of the faces do not tell, those with the smallest angle between the faces. There, duplicate faces come
// after others. A pair that contradicts the orientation of the pairs before is not joined.
class Edge_pairs
{
public:
  static constexpr std::size_t none() { return (std::numeric_limits<std::size_t>::max)(); }

  Edge_pairs(const std::vector<Polygon_soup::Point_3>& points,
             const Face_choice& faces,
             const std::vector<std::size_t>& places)
    : m_points(points),
      m_faces(faces),
      m_places(places),
      m_partner(faces.polygons.number_of_corners(), none()),
      m_is_non_manifold(faces.polygons.number_of_corners(), false),
      m_orientations(faces.polygons.size())
  {
    for (std::size_t face = 0; face < faces.polygons.size(); ++face)
      m_face.insert(m_face.end(), faces.polygons[face].size(), face);

    std::vector<std::size_t> sides(number_of_sides());
    std::iota(sides.begin(), sides.end(), std::size_t(0));
    const std::vector<std::size_t> left = join_manifold_edges(
      sides, [&](std::size_t side) { return ascending(start(side), end(side)); });
    const std::vector<std::size_t> non_manifold = join_manifold_edges(left, [&](std::size_t side)
                                                                      { return places_of_ends(side); });
    join_non_manifold_edges(non_manifold);
  }

  std::size_t number_of_sides() const { return m_face.size(); }
  std::size_t number_of_non_manifold_edges() const { return m_number_of_non_manifold_edges; }
  // of two faces that are not joined, since the faces between them orient them otherwise
  std::size_t number_of_unorientable_edges() const { return m_number_of_unorientable_edges; }

  std::size_t face(std::size_t side) const { return m_face[side]; }
  std::size_t next(std::size_t side) const
  {
    const std::size_t face = m_face[side];
    return side + 1 < first_side(face + 1) ? side + 1 : first_side(face);
  }
  std::size_t previous(std::size_t side) const
  {
    const std::size_t face = m_face[side];
    return side > first_side(face) ? side - 1 : first_side(face + 1) - 1;
  }

  // `none()` if the side lies at the border
  std::size_t partner(std::size_t side) const { return m_partner[side]; }
  void part(std::size_t side)
  {
    if (m_partner[side] == none())
      return;
    m_partner[m_partner[side]] = none();
    m_partner[side] = none();
  }

  // Does the side lie at a non-manifold edge?
  bool is_non_manifold(std::size_t side) const { return m_is_non_manifold[side]; }

  // Do both sides have the same direction, with the faces as they are in the soup?
  bool are_parallel(std::size_t side, std::size_t other) const
  {
    if (start(side) == end(other) && end(side) == start(other))
      return false;
    return m_places[start(side)] == m_places[start(other)];
  }

  // For each face: is it turned over, so that all sides go against their partners? As few as possible are.
  std::vector<bool> turned_faces()
  {
    const std::size_t number_of_faces = m_faces.polygons.size();
    std::vector<std::size_t> size(number_of_faces, 0),
      turned(number_of_faces, 0); // of each set, at its root
    for (std::size_t face = 0; face < number_of_faces; ++face)
    {
      const auto [root, is_turned] = m_orientations.find(face);
      ++size[root];
      turned[root] += is_turned ? 1 : 0;
    }
    std::vector<bool> result;
    for (std::size_t face = 0; face < number_of_faces; ++face)
    {
      const auto [root, is_turned] = m_orientations.find(face);
      result.push_back(is_turned != (2 * turned[root] > size[root]));
    }
    return result;
  }

  // For each face: its connected component, named after one of its faces.
  std::vector<std::size_t> components() const
  {
    Parity_sets sets(m_faces.polygons.size());
    for (std::size_t side = 0; side < m_partner.size(); ++side)
      if (m_partner[side] != none())
        sets.unite(m_face[side], m_face[m_partner[side]], false);
    std::vector<std::size_t> result;
    for (std::size_t face = 0; face < m_faces.polygons.size(); ++face)
      result.push_back(sets.find(face).first);
    return result;
  }

private:
  using Two = std::array<std::size_t, 2>; // the ends of a side, or two sides
  using Vector_3 = Polygon_soup::Vector_3;

  // Where very many sides lie on each other, each is compared with that many of those behind it.
  static constexpr std::size_t enough_candidates = 16;

  static Two ascending(std::size_t a, std::size_t b) { return {(std::min)(a, b), (std::max)(a, b)}; }

  std::size_t first_side(std::size_t face) const { return m_faces.polygons.first_corner(face); }
  std::size_t start(std::size_t side) const { return m_faces.polygons.corner(side); }
  std::size_t end(std::size_t side) const { return m_faces.polygons.corner(next(side)); }
  Two places_of_ends(std::size_t side) const
  {
    return ascending(m_places[start(side)], m_places[end(side)]);
  }

  // Returns whether the orientations fit.
  bool join(std::size_t side, std::size_t other)
  {
    if (!m_orientations.unite(m_face[side], m_face[other], are_parallel(side, other)))
      return false;
    m_partner[side] = other;
    m_partner[other] = side;
    return true;
  }

  // Joins those of `sides` that share their ends with one other side only. The others are returned; those with the same
  // ends follow each other.
  template <typename EndsOf>
  std::vector<std::size_t> join_manifold_edges(const std::vector<std::size_t>& sides,
                                               const EndsOf& ends_of)
  {
    std::vector<std::pair<Two, std::size_t>> sorted;
    for (const std::size_t side : sides)
      if (const Two ends = ends_of(side); ends[0] != ends[1])
        sorted.emplace_back(ends, side);
    std::sort(sorted.begin(), sorted.end());

    std::vector<std::size_t> left;
    std::vector<Two> parallel, opposite;
    for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end)
    {
      while (end < sorted.size() && sorted[end].first == sorted[begin].first)
        ++end;
      const std::size_t a = sorted[begin].second, b = sorted[end - 1].second;
      if (end - begin == 2 && m_face[a] != m_face[b])
        (are_parallel(a, b) ? parallel : opposite).push_back({a, b});
      else
        for (std::size_t i = begin; i < end; ++i)
          left.push_back(sorted[i].second);
    }
    // Faces that are oriented alike come first: they decide how the others are turned.
    for (const std::vector<Two>* pairs : {&opposite, &parallel})
      for (const Two& pair : *pairs)
        m_number_of_unorientable_edges += join(pair[0], pair[1]) ? 0u : 1u;
    return left;
  }

  // `sides` with the same ends follow each other.
  void join_non_manifold_edges(const std::vector<std::size_t>& sides)
  {
    if (sides.empty())
      return;
    const std::vector<Vector_3> normals = unit_normals();
    const std::vector<bool> is_inside_out = are_inside_out(
      m_points, m_faces.polygons, clusters_of_polygons(m_faces.polygons, m_places), m_points.size());
    std::vector<Two> parallel, opposite;
    for (std::size_t begin = 0, last = 0; begin < sides.size(); begin = last)
    {
      while (last < sides.size() && places_of_ends(sides[last]) == places_of_ends(sides[begin]))
        ++last;
      if (last - begin < 3)
        continue;
      ++m_number_of_non_manifold_edges;
      const std::vector<std::size_t> edge(sides.begin() + std::ptrdiff_t(begin),
                                          sides.begin() + std::ptrdiff_t(last));
      for (const std::size_t side : edge)
        m_is_non_manifold[side] = true;
      std::vector<Two> pairs = sides_of_solids(around_edge(edge, normals, is_inside_out));
      if (pairs.empty())
        pairs = by_smoothness(edge, normals);
      for (const Two& pair : pairs)
        (are_parallel(pair[0], pair[1]) ? parallel : opposite).push_back(pair);
    }
    // A solid is not turned inside out for an edge that it shares with another one, unless nothing else fits.
    for (const std::vector<Two>* pairs : {&opposite, &parallel})
      for (const auto& [side, other] : *pairs)
        if (m_partner[side] == none() && m_partner[other] == none())
          join(side, other);
  }

  // None if a face has no normal.
  std::vector<Face_at_edge> around_edge(const std::vector<std::size_t>& sides,
                                        const std::vector<Vector_3>& normals,
                                        const std::vector<bool>& is_inside_out) const
  {
    const std::size_t first = m_places[start(sides.front())];
    const Vector_3 edge = m_points[end(sides.front())] - m_points[start(sides.front())];
    const Vector_3 u = cross_product(normals[m_face[sides.front()]], edge), v = cross_product(edge, u);
    std::vector<Face_at_edge> result;
    for (const std::size_t side : sides)
    {
      const Vector_3& normal = normals[m_face[side]];
      if (normal == NULL_VECTOR)
        return {};
      const bool is_along = m_places[start(side)] == first; // the edge, with the face to the left of it
      const Vector_3 into_face = cross_product(is_along ? normal : -normal, edge);
      result.push_back({std::atan2(into_face * v, std::sqrt(edge.squared_length()) * (into_face * u)),
                        is_along != is_inside_out[m_face[side]], side});
    }
    return result;
  }

  std::vector<Two> by_smoothness(const std::vector<std::size_t>& sides,
                                 const std::vector<Vector_3>& normals) const
  {
    const auto duplicates = [&](std::size_t side) { return m_faces.has_duplicate[m_face[side]] ? 1 : 0; };
    std::vector<std::tuple<int, double, std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t j = i + 1; j < (std::min)(sides.size(), i + 1 + enough_candidates); ++j)
        if (m_face[sides[i]] != m_face[sides[j]])
          pairs.emplace_back(duplicates(sides[i]) + duplicates(sides[j]),
                             -smoothness(sides[i], sides[j], normals), sides[i], sides[j]);
    std::sort(pairs.begin(), pairs.end());
    std::vector<Two> result;
    for (const auto& [number_of_duplicates, cost, side, other] : pairs)
      result.push_back({side, other});
    return result;
  }

  // The cosine of the angle between the normals of the faces, oriented alike: 1 in a plane, -1 where they lie on each
  // other.
  double smoothness(std::size_t side, std::size_t other, const std::vector<Vector_3>& normals) const
  {
    const double cosine = normals[m_face[side]] * normals[m_face[other]];
    return are_parallel(side, other) ? -cosine : cosine;
  }

  std::vector<Vector_3> unit_normals() const
  {
    std::vector<Vector_3> normals;
    for (std::size_t face = 0; face < m_faces.polygons.size(); ++face)
    {
      const Vector_3 n = area_vector(m_points, m_faces.polygons[face]);
      const double length = std::sqrt(n.squared_length());
      normals.push_back(length > 0 ? n / length : Vector_3(0, 0, 0));
    }
    return normals;
  }

  const std::vector<Polygon_soup::Point_3>& m_points;
  const Face_choice& m_faces;
  const std::vector<std::size_t>& m_places;
  std::vector<std::size_t> m_face; // of each side
  std::vector<std::size_t> m_partner;
  std::vector<bool> m_is_non_manifold;
  Parity_sets m_orientations;
  std::size_t m_number_of_non_manifold_edges = 0;
  std::size_t m_number_of_unorientable_edges = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_EDGE_PAIRS_H
