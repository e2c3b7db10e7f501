// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Borders that nearly agree: corners that differ in their last digits, and corners that lie on edges.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_SEW_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_SEW_BORDERS_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Joined_faces.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Parity_sets.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/near_points.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Sews what was joined: sets corners that nearly agree to one place, and corners that lie on sides into these.
class Border_sewer
{
public:
  Border_sewer(Polygon_soup& soup,
               std::vector<std::size_t>& places,
               const Joined_faces& joined,
               double tolerance)
    : m_soup(soup),
      m_places(places),
      m_choice(joined.choice),
      m_tolerance(tolerance),
      m_sets(places.size())
  {
    std::set<std::size_t> points_of_borders;
    std::vector<std::array<std::size_t, 2>> open_sides;
    for (std::size_t side = 0; side < joined.pairs.number_of_sides(); ++side)
    {
      const auto place = [&](std::size_t s) { return places[m_choice.polygons.corner(s)]; };
      const std::array<std::size_t, 2> ends = {place(side), place(joined.pairs.next(side))};
      if (ends[0] == ends[1])
        continue;
      m_sides.push_back(ends);
      m_side.push_back(side);
      m_is_open.push_back(joined.pairs.partner(side) == Edge_pairs::none());
      if (m_is_open.back())
      {
        points_of_borders.insert(ends.begin(), ends.end());
        open_sides.push_back(ends);
      }
      if (squared_distance(soup.points[ends[0]], soup.points[ends[1]]) <= CGAL::square(chain * tolerance))
        m_short_edges.insert({(std::min)(ends[0], ends[1]), (std::max)(ends[0], ends[1])});
    }
    // Where borders are near each other, so may be what was joined to something else: most meshes have neither.
    if (!near_points(soup.points, open_sides, points_of_borders, tolerance).empty())
      m_near = near_points(soup.points, m_sides, points_of_borders, tolerance);
  }

  // Returns the number of places that became one with another one.
  std::size_t join_corners()
  {
    std::vector<
      std::tuple<double, Polygon_soup::Point_3, Polygon_soup::Point_3, std::size_t, std::size_t>>
      pairs;
    for (const Near_point& near_point : m_near)
      for (const std::size_t end : m_sides[near_point.side])
        if (const double d = std::sqrt(squared_distance(m_soup.points[end], m_soup.points[near_point.point]));
            d <= m_tolerance)
        {
          const auto [a, b] = std::minmax({m_soup.points[end], m_soup.points[near_point.point]});
          pairs.emplace_back(d, a, b, end, near_point.point);
        }
    std::sort(pairs.begin(), pairs.end()); // the nearest first
    std::size_t count = 0;
    for (const auto& [distance, a, b, end, point] : pairs)
      count += unite(end, point) ? 1u : 0u;
    if (count > 0)
      name_one_point_of_each_place();
    return count;
  }

  // Returns the number of corners that were set into sides.
  std::size_t split_sides()
  {
    std::map<std::size_t, std::set<std::size_t>> neighbors; // of each place, over sides
    for (std::size_t side = 0; side < m_sides.size(); ++side)
      if (m_is_open[side])
      {
        const std::size_t start = place_of(m_sides[side][0]), end = place_of(m_sides[side][1]);
        neighbors[start].insert(end);
        neighbors[end].insert(start);
      }
    std::map<std::size_t, std::map<std::size_t, double>> on_side; // the positions of places
    for (const Near_point& near_point : m_near)
      if (const std::size_t place = place_of(near_point.point);
          m_is_open[near_point.side] && !is_end(place, near_point.side))
        on_side[near_point.side].emplace(place, near_point.position);
    std::map<std::size_t, std::vector<std::pair<double, std::size_t>>>
      corners; // of each side, in its direction
    std::size_t count = 0;
    for (const auto& [side, places] : on_side)
      for (const auto& [place, position] : places)
      {
        // Others only touch the side.
        const std::set<std::size_t>& beside = neighbors[place];
        if (std::any_of(beside.begin(), beside.end(),
                        [&, s = side, &p = places](std::size_t other)
                        { return is_end(other, s) || p.count(other) > 0; }))
        {
          corners[m_side[side]].emplace_back(position, place);
          ++count;
        }
      }
    if (count > 0)
      insert(corners);
    return count;
  }

private:
  // Places become one over others between them; edges are short if they could vanish so.
  static constexpr double chain = 8;

  std::size_t place_of(std::size_t place)
  {
    const auto members = m_members.find(m_sets.find(place).first);
    return members == m_members.end() ? place : members->second.front();
  }

  bool is_end(std::size_t place, std::size_t side)
  {
    return place == place_of(m_sides[side][0]) || place == place_of(m_sides[side][1]);
  }

  // Polygons whose corners became one name the same point then, as if they had always done so.
  void name_one_point_of_each_place()
  {
    std::vector<std::size_t> point(m_places.size());
    for (std::size_t i = 0; i < point.size(); ++i)
    {
      const bool is_joined = m_members.count(m_sets.find(m_places[i]).first) > 0;
      m_places[i] = place_of(m_places[i]);
      point[i] = is_joined ? m_places[i] : i;
    }
    Polygons polygons;
    for (std::size_t i = 0; i < m_soup.polygons.size(); ++i)
      polygons.add(of_corners(point, m_soup.polygons[i]));
    m_soup.polygons = std::move(polygons);
  }

  // Not if an edge would vanish.
  bool unite(std::size_t a, std::size_t b)
  {
    const std::size_t root_a = m_sets.find(a).first, root_b = m_sets.find(b).first;
    if (root_a == root_b)
      return false;
    const auto members_of = [&](std::size_t root)
    {
      const auto members = m_members.find(root);
      return members == m_members.end() ? std::vector<std::size_t>(1, root) : members->second;
    };
    const std::vector<std::size_t> of_a = members_of(root_a), of_b = members_of(root_b);
    for (const std::size_t p : of_a)
      for (const std::size_t q : of_b)
        if (m_short_edges.count({(std::min)(p, q), (std::max)(p, q)}) > 0)
          return false;
    m_sets.unite(a, b, false);
    m_members.erase(root_a);
    m_members.erase(root_b);
    std::vector<std::size_t>& all = m_members[m_sets.find(a).first];
    std::merge(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(all));
    return true;
  }

  void insert(std::map<std::size_t, std::vector<std::pair<double, std::size_t>>>& corners)
  {
    Polygons polygons;
    std::size_t face = 0;
    for (std::size_t i = 0; i < m_soup.polygons.size(); ++i)
    {
      if (face == m_choice.kept.size() || m_choice.kept[face] != i)
      {
        polygons.add(m_soup.polygons[i]);
        continue;
      }
      std::vector<std::size_t> polygon;
      for (std::size_t c = m_choice.polygons.first_corner(face);
           c < m_choice.polygons.first_corner(face + 1); ++c)
      {
        polygon.push_back(m_choice.polygons.corner(c));
        if (const auto found = corners.find(c); found != corners.end())
        {
          std::sort(found->second.begin(), found->second.end());
          for (const auto& [position, place] : found->second)
            polygon.push_back(place);
        }
      }
      polygons.add(polygon);
      ++face;
    }
    m_soup.polygons = std::move(polygons);
  }

  Polygon_soup& m_soup;
  std::vector<std::size_t>& m_places;
  const Face_choice& m_choice;
  double m_tolerance;
  std::vector<std::array<std::size_t, 2>> m_sides; // by the places of their ends
  std::vector<std::size_t> m_side;                 // of `m_choice`
  std::vector<bool> m_is_open;                     // has it no partner?
  std::vector<Near_point> m_near;
  std::set<std::pair<std::size_t, std::size_t>> m_short_edges;
  Parity_sets m_sets;                                        // of places that become one
  std::map<std::size_t, std::vector<std::size_t>> m_members; // of sets of several places, ascending
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_SEW_BORDERS_H
