// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_POLYGON_SOUP_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_POLYGON_SOUP_H

#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Polygons of any number of corners in a row; the corners of all of them are numbered in a row, too.
class Polygons
{
public:
  using Corners = boost::iterator_range<std::vector<std::size_t>::const_iterator>;

  std::size_t size() const { return m_first.size() - 1; }
  const std::vector<std::size_t>& corners() const { return m_corners; } // of all
  std::size_t number_of_corners() const { return m_corners.size(); }
  std::size_t first_corner(std::size_t polygon) const { return m_first[polygon]; }
  std::size_t corner(std::size_t number) const { return m_corners[number]; }
  Corners operator[](std::size_t polygon) const
  {
    const auto begin = m_corners.begin();
    return {begin + std::ptrdiff_t(m_first[polygon]), begin + std::ptrdiff_t(m_first[polygon + 1])};
  }

  template <typename Range>
  void add(const Range& corners)
  {
    m_corners.insert(m_corners.end(), corners.begin(), corners.end());
    m_first.push_back(m_corners.size());
  }

private:
  std::vector<std::size_t> m_first = {0}; // of every polygon, and the end
  std::vector<std::size_t> m_corners;
};

// Polygons whose corners are indices of points, whatever is wrong with them.
struct Polygon_soup
{
  using Point_3 = Simple_cartesian<double>::Point_3;
  using Vector_3 = Simple_cartesian<double>::Vector_3;

  std::vector<Point_3> points;
  Polygons polygons;
};

// The points of corners, or what else is given for each point.
template <typename T, typename Corners>
std::vector<T> of_corners(const std::vector<T>& of_points, const Corners& corners)
{
  std::vector<T> result;
  for (const std::size_t corner : corners)
    result.push_back(of_points[corner]);
  return result;
}

// Along the normal of the polygon and as long as its area is large.
template <typename Corners>
Polygon_soup::Vector_3 area_vector(const std::vector<Polygon_soup::Point_3>& points,
                                   const Corners& corners)
{
  return polygon_area_vector(of_corners(points, corners));
}

// Points that lie on each other are at one place, which is named by the first of them.
inline std::vector<std::size_t> places(const std::vector<Polygon_soup::Point_3>& points)
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
              const Polygon_soup::Point_3 &p = points[a.second], &q = points[b.second];
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

// Scales the points by a power of two, which changes no digit, so that squares of areas neither overflow nor vanish. Points
// without a polygon do not count: a far one would make the rest tiny. Returns the exponent of the power that scales back.
inline int scale_to_unit(Polygon_soup& soup)
{
  Largest_coordinate largest;
  for (const std::size_t corner : soup.polygons.corners())
    largest.add(soup.points[corner]);
  for (Polygon_soup::Point_3& p : soup.points)
    p = scaled_by_power_of_two(p, -largest.exponent());
  return largest.exponent();
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_POLYGON_SOUP_H
