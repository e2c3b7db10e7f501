// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_CHOOSE_FACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_CHOOSE_FACES_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The polygons that become faces, and the faces that label those that do not.
struct Face_choice
{
  std::vector<std::size_t> kept;        // polygons, ascending
  std::vector<std::size_t> label_giver; // of each polygon: a position in `kept`
  Polygons polygons;                    // those kept, without corners twice in a row
  std::vector<bool> has_duplicate;         // for each kept one: is there another one with the same corners?
  std::size_t degenerate_polygons = 0;
  std::size_t duplicate_polygons = 0;
};

class Face_chooser
{
public:
  Face_chooser(const Polygons& polygons,
               const std::vector<std::size_t>& places,
               const std::vector<bool>& is_left_out)
    : m_polygons(polygons), m_places(places), m_is_left_out(is_left_out)
  {}

  Face_choice choose()
  {
    find_duplicates();
    m_choice.label_giver.assign(m_polygons.size(), none());
    for (std::size_t i = 0; i < m_polygons.size(); ++i)
      add(i);
    if (m_choice.kept.empty())
      throw std::invalid_argument("polygons: none has three different corners");
    label_by_neighbors();
    return std::move(m_choice);
  }

private:
  using Corners = std::vector<std::size_t>;

  // More faces than that at one place are not asked for their label.
  static constexpr std::size_t enough_neighbors = 64;

  static constexpr std::size_t none() { return (std::numeric_limits<std::size_t>::max)(); }

  static std::size_t number_of_different(Corners corners)
  {
    std::sort(corners.begin(), corners.end());
    return std::size_t(std::unique(corners.begin(), corners.end()) - corners.begin());
  }

  // The same for all polygons with the same corners in the same order or the reverse one.
  static Corners canonical(Corners corners)
  {
    const auto begin_with_smallest = [](Corners& polygon)
    { std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end()); };
    begin_with_smallest(corners);
    Corners reverse(corners.rbegin(), corners.rend());
    begin_with_smallest(reverse);
    return (std::min)(corners, reverse);
  }

  // Corners that follow themselves are named once.
  Corners without_repetitions(std::size_t polygon) const
  {
    Corners corners(m_polygons[polygon].begin(), m_polygons[polygon].end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    while (corners.size() > 1 && corners.front() == corners.back())
      corners.pop_back();
    return corners;
  }

  Corners places_of(std::size_t polygon) const
  {
    Corners result;
    for (const std::size_t corner : m_polygons[polygon])
      result.push_back(m_places[corner]);
    return result;
  }

  // For each polygon the first one with the same corners. Those that touch themselves are no duplicates.
  void find_duplicates()
  {
    std::vector<std::pair<Corners, std::size_t>> polygons;
    for (std::size_t i = 0; i < m_polygons.size(); ++i)
    {
      const Corners corners = places_of(i);
      if (corners.size() >= 3 && number_of_different(corners) == corners.size())
        polygons.emplace_back(canonical(corners), i);
    }
    std::sort(polygons.begin(), polygons.end());
    m_has_duplicate.assign(m_polygons.size(), false);
    m_first_duplicate.resize(m_polygons.size());
    std::iota(m_first_duplicate.begin(), m_first_duplicate.end(), std::size_t(0));
    for (std::size_t i = 1; i < polygons.size(); ++i)
      if (polygons[i].first == polygons[i - 1].first)
      {
        const std::size_t first = m_first_duplicate[polygons[i - 1].second];
        m_first_duplicate[polygons[i].second] = first;
        m_has_duplicate[first] = true;
      }
  }

  void add(std::size_t polygon)
  {
    const Corners corners = without_repetitions(polygon);
    const std::size_t first = m_first_duplicate[polygon];
    // A triangle that comes back to a corner has no area; a polygon may have some.
    if (number_of_different(corners) < 3)
      ++m_choice.degenerate_polygons;
    else if (first != polygon)
    {
      ++m_choice.duplicate_polygons;
      m_choice.label_giver[polygon] = m_choice.label_giver[first];
    }
    else if (!m_is_left_out[polygon])
    {
      m_choice.label_giver[polygon] = m_choice.kept.size();
      m_choice.kept.push_back(polygon);
      m_choice.polygons.add(corners);
      m_choice.has_duplicate.push_back(m_has_duplicate[polygon]);
    }
  }

  void label_by_neighbors()
  {
    collect_neighbors();
    for (std::size_t polygon = 0; polygon < m_polygons.size(); ++polygon)
      if (m_choice.label_giver[polygon] == none())
        m_choice.label_giver[polygon] = neighbor_of(polygon);
  }

  void collect_neighbors()
  {
    for (std::size_t polygon = 0; polygon < m_polygons.size(); ++polygon)
      if (m_choice.label_giver[polygon] == none())
        for (const std::size_t place : places_of(polygon))
          m_faces_at[place];
    for (std::size_t i = 0; i < m_choice.kept.size() && !m_faces_at.empty(); ++i)
      for (const std::size_t corner : m_choice.polygons[i])
        if (const auto found = m_faces_at.find(m_places[corner]);
            found != m_faces_at.end() && found->second.size() < enough_neighbors)
          found->second.push_back(i);
  }

  // The kept one that shares the most places, of several the first.
  std::size_t neighbor_of(std::size_t polygon) const
  {
    const Corners all = places_of(polygon);
    std::map<std::size_t, std::size_t> shared;
    for (const std::size_t place : std::set<std::size_t>(all.begin(), all.end()))
      for (const std::size_t kept : m_faces_at.at(place))
        ++shared[kept];
    std::pair<std::size_t, std::size_t> best = {none(), 0};
    for (const auto& candidate : shared)
      if (candidate.second > best.second)
        best = candidate;
    return best.first != none() ? best.first : kept_one_beside(polygon);
  }

  // The last kept one before this one, or the first of all.
  std::size_t kept_one_beside(std::size_t polygon) const
  {
    const auto after = std::lower_bound(m_choice.kept.begin(), m_choice.kept.end(), polygon);
    const std::size_t before = std::size_t(after - m_choice.kept.begin());
    return before > 0 ? before - 1 : 0;
  }

  const Polygons& m_polygons;
  const std::vector<std::size_t>& m_places;
  const std::vector<bool>& m_is_left_out;
  std::vector<std::size_t> m_first_duplicate;
  std::vector<bool> m_has_duplicate;
  // at the places of polygons that want a label
  std::unordered_map<std::size_t, std::vector<std::size_t>> m_faces_at;
  Face_choice m_choice;
};

// Of polygons with the same corners the first one is kept and labels the others. A polygon that has fewer than three
// corners is labelled by a neighbour: one that shares an edge with it, or a corner, or else the one before it. So is a
// polygon with `is_left_out`. Throws if no polygon can be kept.
inline Face_choice choose_faces(const Polygons& polygons,
                                const std::vector<std::size_t>& places,
                                const std::vector<bool>& is_left_out)
{
  return Face_chooser(polygons, places, is_left_out).choose();
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_CHOOSE_FACES_H
