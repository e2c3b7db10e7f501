// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/Edge_pairs.h"

#include "repair/area_vector.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace tool
{
namespace
{

// Where very many sides lie on each other, each is compared with that many of those behind it.
constexpr std::size_t enough_candidates = 16;

std::array<std::size_t, 2> ascending(std::size_t a, std::size_t b)
{
  return {(std::min)(a, b), (std::max)(a, b)};
}

} // namespace

Edge_pairs::Edge_pairs(const std::vector<Point>& points,
                       const Face_choice& faces,
                       const std::vector<std::size_t>& places)
  : m_points(points),
    m_faces(faces),
    m_places(places),
    m_orientations(faces.polygons.size())
{
  const std::vector<Polygon>& polygons = faces.polygons;
  for (std::size_t face = 0; face < polygons.size(); ++face)
  {
    m_first.push_back(m_corner.size());
    m_corner.insert(m_corner.end(), polygons[face].begin(), polygons[face].end());
    m_face.resize(m_corner.size(), face);
  }
  m_first.push_back(m_corner.size());
  m_partner.assign(m_corner.size(), none);
  m_is_crowded.assign(m_corner.size(), false);

  std::vector<std::size_t> sides(m_corner.size());
  std::iota(sides.begin(), sides.end(), std::size_t(0));
  const std::vector<std::size_t> left = join_lonely_pairs(sides, [&](std::size_t side)
                                                          { return ascending(start(side), end(side)); });
  const std::vector<std::size_t> crowded = join_lonely_pairs(
    left, [&](std::size_t side) { return ascending(m_places[start(side)], m_places[end(side)]); });
  join_smoothest(crowded);
}

bool Edge_pairs::are_parallel(std::size_t side, std::size_t other) const
{
  if (start(side) == end(other) && end(side) == start(other))
    return false;
  return m_places[start(side)] == m_places[start(other)];
}

void Edge_pairs::part(std::size_t side)
{
  if (m_partner[side] == none)
    return;
  m_partner[m_partner[side]] = none;
  m_partner[side] = none;
}

void Edge_pairs::join(std::size_t side, std::size_t other)
{
  const bool is_turned = are_parallel(side, other);
  if (!m_orientations.fits(m_face[side], m_face[other], is_turned))
    return;
  m_orientations.unite(m_face[side], m_face[other], is_turned);
  m_partner[side] = other;
  m_partner[other] = side;
}

// Joins those of `sides` that share their ends with one other side only. The others are returned, but for those
// that are alone; those with the same ends stand in a row.
template <typename EndsOf>
std::vector<std::size_t> Edge_pairs::join_lonely_pairs(const std::vector<std::size_t>& sides,
                                                       const EndsOf& ends_of)
{
  std::vector<std::pair<Ends, std::size_t>> sorted;
  for (const std::size_t side : sides)
    if (const Ends ends = ends_of(side); ends[0] != ends[1])
      sorted.emplace_back(ends, side);
  std::sort(sorted.begin(), sorted.end());

  std::vector<std::size_t> left;
  std::vector<Ends> parallel, opposite;
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
  for (const std::vector<Ends>* pairs : {&opposite, &parallel})
    for (const Ends& pair : *pairs)
      join(pair[0], pair[1]);
  return left;
}

// `sides` with the same ends stand in a row.
void Edge_pairs::join_smoothest(const std::vector<std::size_t>& sides)
{
  const auto ends_of = [&](std::size_t side)
  { return ascending(m_places[start(side)], m_places[end(side)]); };
  std::vector<Ends> parallel, opposite;
  for (std::size_t begin = 0, last = 0; begin < sides.size(); begin = last)
  {
    while (last < sides.size() && ends_of(sides[last]) == ends_of(sides[begin]))
      ++last;
    if (last - begin < 3)
      continue;
    ++m_number_of_non_manifold_edges;
    for (std::size_t i = begin; i < last; ++i)
      m_is_crowded[sides[i]] = true;
    for (const Ends& pair :
         by_smoothness({sides.begin() + std::ptrdiff_t(begin), sides.begin() + std::ptrdiff_t(last)}))
      (are_parallel(pair[0], pair[1]) ? parallel : opposite).push_back(pair);
  }
  // A solid is not turned inside out for an edge that it shares with another one, unless nothing else fits.
  for (const std::vector<Ends>* pairs : {&opposite, &parallel})
    for (const auto& [side, other] : *pairs)
      if (m_partner[side] == none && m_partner[other] == none)
        join(side, other);
}

std::vector<Edge_pairs::Ends> Edge_pairs::by_smoothness(const std::vector<std::size_t>& sides) const
{
  const auto doubles = [&](std::size_t side) { return m_faces.has_double[m_face[side]] ? 1 : 0; };
  std::vector<std::tuple<int, double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < (std::min)(sides.size(), i + 1 + enough_candidates); ++j)
      if (m_face[sides[i]] != m_face[sides[j]])
        pairs.emplace_back(doubles(sides[i]) + doubles(sides[j]), -smoothness(sides[i], sides[j]), sides[i],
                           sides[j]);
  std::sort(pairs.begin(), pairs.end());
  std::vector<Ends> result;
  for (const auto& [doubled, cost, side, other] : pairs)
    result.push_back({side, other});
  return result;
}

// The cosine of the angle between the normals of the faces, oriented alike: 1 in a plane, -1 where they lie on each other.
double Edge_pairs::smoothness(std::size_t side, std::size_t other) const
{
  const auto unit_normal = [&](std::size_t s)
  {
    const auto corner = m_corner.begin();
    const std::size_t f = m_face[s];
    const Vector n = area_vector(
      m_points, Polygon(corner + std::ptrdiff_t(m_first[f]), corner + std::ptrdiff_t(m_first[f + 1])));
    const double length = std::sqrt(n.squared_length());
    return length > 0 && std::isfinite(length) ? n / length : Vector(0, 0, 0);
  };
  const double cosine = unit_normal(side) * unit_normal(other);
  return are_parallel(side, other) ? -cosine : cosine;
}

std::vector<bool> Edge_pairs::turned_faces()
{
  const std::size_t number_of_faces = m_first.size() - 1;
  std::vector<std::size_t> size(number_of_faces, 0), turned(number_of_faces, 0); // of each set, at its root
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

std::vector<std::size_t> Edge_pairs::components() const
{
  Parity_sets sets(m_first.size() - 1);
  for (std::size_t side = 0; side < m_partner.size(); ++side)
    if (m_partner[side] != none)
      sets.unite(m_face[side], m_face[m_partner[side]], false);
  std::vector<std::size_t> result;
  for (std::size_t face = 0; face + 1 < m_first.size(); ++face)
    result.push_back(sets.find(face).first);
  return result;
}

} // namespace tool
