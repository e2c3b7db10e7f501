// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_CHOOSE_FACES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_CHOOSE_FACES_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The polygons that become faces, and those that label their duplicates.
struct Face_choice
{
  static constexpr std::size_t none() { return (std::numeric_limits<std::size_t>::max)(); }

  std::vector<std::size_t> kept;        // polygons, ascending
  std::vector<std::size_t> label_giver; // of each polygon: a position in `kept`, or none
  Polygons polygons;                    // those kept, without corners twice in a row
  std::vector<std::size_t> alike;  // for each kept one: the first with the same corners, of any surface
  std::vector<bool> has_duplicate; // for each kept one: is there another one with the same corners?
  std::size_t degenerate_polygons = 0;
  std::size_t duplicate_polygons = 0;
};

// Of two polygons with the same corners in opposite order one is reversed.
inline bool is_reversed(const std::vector<std::size_t>& corners)
{
  if (corners.empty())
    return false;
  const auto smallest = std::min_element(corners.begin(), corners.end());
  const std::size_t previous = smallest == corners.begin() ? corners.back() : *(smallest - 1);
  const std::size_t next = smallest + 1 == corners.end() ? corners.front() : *(smallest + 1);
  return previous < next;
}

// The number of all surfaces that are not closed, where closed ones have numbers of their own.
constexpr std::size_t open_surface = 0;

// Of polygons with the same corners and of the same surface the first one is kept and labels the others. A polygon without
// three different corners is not kept, nor is one with `is_left_out`.
class Face_chooser
{
public:
  Face_chooser(const Polygons& polygons,
               const std::vector<std::size_t>& places,
               const std::vector<std::size_t>& surfaces,
               const std::vector<bool>& is_left_out)
    : m_polygons(polygons),
      m_places(places),
      m_surfaces(surfaces),
      m_is_left_out(is_left_out)
  {}

  // Throws if no polygon can be kept.
  Face_choice choose()
  {
    find_duplicates();
    m_choice.label_giver.assign(m_polygons.size(), Face_choice::none());
    for (std::size_t i = 0; i < m_polygons.size(); ++i)
      add(i);
    for (std::size_t i = 0; i < m_polygons.size(); ++i)
      if (m_first_duplicate[i] != i)
        m_choice.label_giver[i] = m_choice.label_giver[m_first_duplicate[i]];
    if (m_choice.kept.empty())
      throw std::invalid_argument("polygons: none has three different corners");
    return std::move(m_choice);
  }

private:
  using Corners = std::vector<std::size_t>;

  static std::size_t number_of_different(Corners corners)
  {
    std::sort(corners.begin(), corners.end());
    return std::size_t(std::unique(corners.begin(), corners.end()) - corners.begin());
  }

  // The same for all polygons with the same corners in the same order or the reverse one.
  static Corners canonical(Corners corners)
  {
    if (is_reversed(corners))
      std::reverse(corners.begin(), corners.end());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
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

  // For each polygon the first one with the same corners and of the same surface; an open surface is part of any other one
  // there. Polygons that touch themselves are no duplicates.
  void find_duplicates()
  {
    std::vector<std::tuple<Corners, std::size_t, std::size_t>> polygons; // corners, surface, number
    for (std::size_t i = 0; i < m_polygons.size(); ++i)
    {
      const Corners corners = of_corners(m_places, m_polygons[i]);
      if (corners.size() >= 3 && number_of_different(corners) == corners.size())
        polygons.emplace_back(canonical(corners), m_surfaces[i], i);
    }
    std::sort(polygons.begin(), polygons.end());
    m_has_duplicate.assign(m_polygons.size(), false);
    m_first_duplicate.resize(m_polygons.size());
    std::iota(m_first_duplicate.begin(), m_first_duplicate.end(), std::size_t(0));
    m_alike = m_first_duplicate;
    for (auto begin = polygons.begin(), end = begin; begin != polygons.end(); begin = end)
    {
      const auto is_other = [&](const auto& polygon)
      { return std::get<0>(polygon) != std::get<0>(*begin); };
      end = std::find_if(begin, polygons.end(), is_other);
      auto first = std::find_if(begin, end,
                                [](const auto& polygon) { return std::get<1>(polygon) != open_surface; });
      if (first == end)
        first = begin;
      for (auto i = begin; i != end; ++i)
      {
        if (i > first && std::get<1>(*i) != std::get<1>(*first))
          first = i;
        m_first_duplicate[std::get<2>(*i)] = std::get<2>(*first);
        m_alike[std::get<2>(*i)] = std::get<2>(*begin);
        m_has_duplicate[std::get<2>(*i)] = end - begin > 1;
      }
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
      ++m_choice.duplicate_polygons;
    else if (!m_is_left_out[polygon])
    {
      m_choice.label_giver[polygon] = m_choice.kept.size();
      m_choice.kept.push_back(polygon);
      m_choice.polygons.add(corners);
      m_choice.alike.push_back(m_alike[polygon]);
      m_choice.has_duplicate.push_back(m_has_duplicate[polygon]);
    }
  }

  const Polygons& m_polygons;
  const std::vector<std::size_t>& m_places;
  const std::vector<std::size_t>& m_surfaces;
  const std::vector<bool>& m_is_left_out;
  std::vector<std::size_t> m_first_duplicate;
  std::vector<std::size_t> m_alike;
  std::vector<bool> m_has_duplicate;
  Face_choice m_choice;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_CHOOSE_FACES_H
