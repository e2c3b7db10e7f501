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

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The distance up to which corners, of which all points are some, are taken for equal if none is given. Numbers rounded to
// single precision differ by some units in the last place. Other files differ by about a millionth of the size, in each
// coordinate and to both sides.
template <typename Points>
double automatic_tolerance(const Points& points)
{
  constexpr double share_of_size = 4e-6, units_in_last_place = 4;
  Bbox_3 box;
  bool is_single_precision = true;
  for (const Polygon_soup::Point_3& p : points)
  {
    box += p.bbox();
    for (const double x : {p.x(), p.y(), p.z()})
      is_single_precision = is_single_precision && static_cast<double>(static_cast<float>(x)) == x;
  }
  const double size = (std::max)({box.x_span(), box.y_span(), box.z_span()});
  const double largest = (std::max)(
    {-box.xmin(), -box.ymin(), -box.zmin(), box.xmax(), box.ymax(), box.zmax()});
  const double unit = is_single_precision ? std::ldexp(largest, -std::numeric_limits<float>::digits) : 0;
  return (std::max)(share_of_size * size, units_in_last_place * unit);
}

// A point near a side of a border, between its ends or at one of them.
struct Near_point
{
  double distance;
  double position; // along the side, 0 to 1
  std::size_t side;
  std::size_t point;
};

// All of them. A side is given by the points at its ends; its points are no farther than half its length.
inline std::vector<Near_point> near_points(const std::vector<Polygon_soup::Point_3>& points,
                                           const std::vector<std::array<std::size_t, 2>>& sides,
                                           double tolerance)
{
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  const auto tolerance_of = [&](std::size_t side)
  {
    return (std::min)(tolerance,
                      std::sqrt(squared_distance(points[sides[side][0]], points[sides[side][1]])) / 2);
  };
  std::vector<Box> boxes, points_of_sides;
  std::set<std::size_t> ends;
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    const Bbox_3 b = points[sides[s][0]].bbox() + points[sides[s][1]].bbox();
    const double t = tolerance_of(s);
    boxes.emplace_back(
      Bbox_3(b.xmin() - t, b.ymin() - t, b.zmin() - t, b.xmax() + t, b.ymax() + t, b.zmax() + t), s);
    ends.insert(sides[s].begin(), sides[s].end());
  }
  for (const std::size_t end : ends)
    points_of_sides.emplace_back(points[end].bbox(), end);
  std::vector<Near_point> result;
  box_intersection_d(boxes.begin(), boxes.end(), points_of_sides.begin(), points_of_sides.end(),
                     [&](const Box& side_box, const Box& point_box)
                     {
                       const std::size_t side = side_box.info(), point = point_box.info();
                       const auto& [start, end] = sides[side];
                       if (point == start || point == end)
                         return;
                       const Polygon_soup::Vector_3 along = points[end] - points[start],
                                                    to_point = points[point] - points[start];
                       const double position = (std::min)(
                         (std::max)(to_point * along / along.squared_length(), 0.), 1.);
                       const double distance = std::sqrt((to_point - position * along).squared_length());
                       if (distance <= tolerance_of(side))
                         result.push_back({distance, position, side, point});
                     });
  return result;
}

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
    for (std::size_t side = 0; side < joined.pairs.number_of_sides(); ++side)
    {
      const auto place = [&](std::size_t s) { return places[m_choice.polygons.corner(s)]; };
      const std::array<std::size_t, 2> ends = {place(side), place(joined.pairs.next(side))};
      if (ends[0] == ends[1])
        continue;
      if (joined.pairs.partner(side) == Edge_pairs::none())
      {
        m_sides.push_back(ends);
        m_side.push_back(side);
      }
      if (squared_distance(soup.points[ends[0]], soup.points[ends[1]]) <= CGAL::square(chain * tolerance))
        m_short_edges.insert({(std::min)(ends[0], ends[1]), (std::max)(ends[0], ends[1])});
    }
    m_near = near_points(soup.points, m_sides, tolerance);
  }

  // Returns the number of places that became one with another one.
  std::size_t join_corners()
  {
    std::vector<
      std::tuple<double, Polygon_soup::Point_3, Polygon_soup::Point_3, std::size_t, std::size_t>>
      pairs;
    for (const Near_point& near : m_near)
      for (const std::size_t end : m_sides[near.side])
        if (const double d = std::sqrt(squared_distance(m_soup.points[end], m_soup.points[near.point]));
            d <= m_tolerance)
        {
          const auto [a, b] = std::minmax({m_soup.points[end], m_soup.points[near.point]});
          pairs.emplace_back(d, a, b, end, near.point);
        }
    std::sort(pairs.begin(), pairs.end()); // the nearest first
    std::size_t count = 0;
    for (const auto& [distance, a, b, end, point] : pairs)
      count += unite(end, point) ? 1u : 0u;
    for (std::size_t& place : m_places)
      place = place_of(place);
    return count;
  }

  // Returns the number of corners that were set into sides.
  std::size_t split_sides()
  {
    std::map<std::size_t, std::set<std::size_t>> neighbors; // of each place, over sides
    for (const auto& [start, end] : m_sides)
    {
      neighbors[place_of(start)].insert(place_of(end));
      neighbors[place_of(end)].insert(place_of(start));
    }
    std::map<std::size_t, std::map<std::size_t, double>> on_side; // the positions of places
    for (const Near_point& near : m_near)
      if (const std::size_t place = place_of(near.point); !is_end(place, near.side))
        on_side[near.side].emplace(place, near.position);
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
  std::vector<std::array<std::size_t, 2>> m_sides; // without partner, by the places of their ends
  std::vector<std::size_t> m_side;                 // of `m_choice`
  std::vector<Near_point> m_near;
  std::set<std::pair<std::size_t, std::size_t>> m_short_edges;
  Parity_sets m_sets;                                        // of places that become one
  std::map<std::size_t, std::vector<std::size_t>> m_members; // of sets of several places, ascending
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_SEW_BORDERS_H
