// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/Face_choice.h"

#include "reading/Format_error.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

namespace tool
{
namespace
{

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

// More faces than that at one place are not asked for their label.
constexpr std::size_t enough_neighbors = 64;

std::size_t number_of_different(Polygon corners)
{
  std::sort(corners.begin(), corners.end());
  return std::size_t(std::unique(corners.begin(), corners.end()) - corners.begin());
}

// Corners that follow themselves are named once.
Polygon without_repetitions(Polygon polygon)
{
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.front() == polygon.back())
    polygon.pop_back();
  return polygon;
}

// A triangle that comes back to a corner has no area; a polygon may have some.
bool is_degenerate(const Polygon& polygon)
{
  return number_of_different(polygon) < 3;
}

// The same for all polygons with the same corners in the same order or the reverse one.
Polygon canonical(Polygon corners)
{
  const auto begin_with_smallest = [](Polygon& polygon)
  { std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end()); };
  begin_with_smallest(corners);
  Polygon reverse(corners.rbegin(), corners.rend());
  begin_with_smallest(reverse);
  return (std::min)(corners, reverse);
}

class Chooser
{
public:
  Chooser(const Polygon_soup& soup,
          const std::vector<std::size_t>& places,
          const std::vector<bool>& is_left_out)
    : m_soup(soup),
      m_places(places),
      m_is_left_out(is_left_out)
  {}

  Face_choice choose()
  {
    find_doubles();
    m_choice.label_giver.assign(m_soup.polygons.size(), none);
    for (std::size_t i = 0; i < m_soup.polygons.size(); ++i)
      add(i);
    if (m_choice.kept.empty())
      throw Format_error("has degenerate faces only: none has three different corners");
    label_by_neighbors();
    return std::move(m_choice);
  }

private:
  Polygon places_of(const Polygon& polygon) const
  {
    Polygon result;
    for (const std::size_t corner : polygon)
      result.push_back(m_places[corner]);
    return result;
  }

  // For each face the first one with the same corners. Faces that touch themselves are no doubles.
  void find_doubles()
  {
    std::vector<std::pair<Polygon, std::size_t>> faces;
    for (std::size_t i = 0; i < m_soup.polygons.size(); ++i)
    {
      const Polygon corners = places_of(m_soup.polygons[i]);
      if (corners.size() >= 3 && number_of_different(corners) == corners.size())
        faces.emplace_back(canonical(corners), i);
    }
    std::sort(faces.begin(), faces.end());
    m_has_double.assign(m_soup.polygons.size(), false);
    m_first_double.resize(m_soup.polygons.size());
    std::iota(m_first_double.begin(), m_first_double.end(), std::size_t(0));
    for (std::size_t i = 1; i < faces.size(); ++i)
      if (faces[i].first == faces[i - 1].first)
      {
        const std::size_t first = m_first_double[faces[i - 1].second];
        m_first_double[faces[i].second] = first;
        m_has_double[first] = true;
      }
  }

  void add(std::size_t face)
  {
    const Polygon polygon = without_repetitions(m_soup.polygons[face]);
    const std::size_t first = m_first_double[face];
    if (is_degenerate(polygon))
      ++m_choice.degenerate_faces;
    else if (first != face)
    {
      ++m_choice.duplicate_faces;
      m_choice.label_giver[face] = m_choice.label_giver[first];
    }
    else if (!m_is_left_out[face])
    {
      m_choice.label_giver[face] = m_choice.kept.size();
      m_choice.kept.push_back(face);
      m_choice.polygons.push_back(polygon);
      m_choice.has_double.push_back(m_has_double[face]);
    }
  }

  void label_by_neighbors()
  {
    collect_neighbors();
    for (std::size_t face = 0; face < m_soup.polygons.size(); ++face)
      if (m_choice.label_giver[face] == none)
        m_choice.label_giver[face] = neighbor_of(face);
  }

  void collect_neighbors()
  {
    for (std::size_t face = 0; face < m_soup.polygons.size(); ++face)
      if (m_choice.label_giver[face] == none)
        for (const std::size_t place : places_of(m_soup.polygons[face]))
          m_faces_at[place];
    for (std::size_t i = 0; i < m_choice.kept.size() && !m_faces_at.empty(); ++i)
      for (const std::size_t corner : m_choice.polygons[i])
        if (const auto found = m_faces_at.find(m_places[corner]);
            found != m_faces_at.end() && found->second.size() < enough_neighbors)
          found->second.push_back(i);
  }

  // The kept face that shares the most places, of several the first.
  std::size_t neighbor_of(std::size_t face) const
  {
    const Polygon all = places_of(m_soup.polygons[face]);
    std::map<std::size_t, std::size_t> shared;
    for (const std::size_t place : std::set<std::size_t>(all.begin(), all.end()))
      for (const std::size_t kept : m_faces_at.at(place))
        ++shared[kept];
    std::pair<std::size_t, std::size_t> best = {none, 0};
    for (const auto& candidate : shared)
      if (candidate.second > best.second)
        best = candidate;
    return best.first != none ? best.first : kept_face_beside(face);
  }

  // The last kept face before this one in the file, or the first of all.
  std::size_t kept_face_beside(std::size_t face) const
  {
    const auto after = std::lower_bound(m_choice.kept.begin(), m_choice.kept.end(), face);
    const std::size_t before = std::size_t(after - m_choice.kept.begin());
    return before > 0 ? before - 1 : 0;
  }

  const Polygon_soup& m_soup;
  const std::vector<std::size_t>& m_places;
  const std::vector<bool>& m_is_left_out;
  std::vector<std::size_t> m_first_double;
  std::vector<bool> m_has_double;
  std::unordered_map<std::size_t, std::vector<std::size_t>>
    m_faces_at; // the places of faces that want a label
  Face_choice m_choice;
};

} // namespace

std::vector<std::size_t> places(const std::vector<Point>& points)
{
  // with their first coordinates: a comparison seldom has to look up the points
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    order.emplace_back(points[i].x(), i);
  std::sort(order.begin(), order.end(),
            [&](const auto& a, const auto& b)
            {
              if (a.first != b.first)
                return a.first < b.first;
              const Point &p = points[a.second], &q = points[b.second];
              return p < q || (p == q && a.second < b.second);
            });
  std::vector<std::size_t> result(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const std::size_t point = order[i].second;
    const bool is_new = i == 0 || points[point] != points[order[i - 1].second];
    result[point] = is_new ? point : result[order[i - 1].second];
  }
  return result;
}

Face_choice choose_faces(const Polygon_soup& soup,
                         const std::vector<std::size_t>& places,
                         const std::vector<bool>& is_left_out)
{
  return Chooser(soup, places, is_left_out).choose();
}

} // namespace tool
