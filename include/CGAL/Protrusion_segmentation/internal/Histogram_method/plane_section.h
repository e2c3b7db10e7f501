// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_PLANE_SECTION_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_PLANE_SECTION_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A plane by a point of it and its normal, which need not have unit length.
struct Section_plane
{
  Indexed_surface::Point_3 origin;
  Indexed_surface::Vector_3 normal;

  // above the plane, times the length of the normal
  double height(const Indexed_surface::Point_3& p) const { return (p - origin) * normal; }
};

// The largest squared distance between two points, by all pairs.
template <typename Point>
double largest_squared_distance(const std::vector<Point>& points)
{
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      largest = (std::max)(largest, squared_distance(points[i], points[j]));
  return largest;
}

// The same for the vertices of a convex polygon, counterclockwise, by rotating calipers: linear time.
template <typename Point>
double largest_squared_distance_of_antipodal_pairs(const std::vector<Point>& hull)
{
  const std::size_t h = hull.size();
  const auto next = [h](std::size_t i) { return i + 1 < h ? i + 1 : 0; };
  double largest = 0;
  for (std::size_t i = 0, j = next(0); i < h; ++i)
  {
    // Walk on while the next vertex is farther from the edge that begins at vertex i. No walk takes a whole turn, but the
    // rounded determinants of a very thin hull may all be positive.
    const auto edge = hull[next(i)] - hull[i];
    for (std::size_t step = 0; step < h && determinant(edge, hull[next(j)] - hull[j]) > 0; ++step)
      j = next(j);
    largest = (std::max)(
      {largest, squared_distance(hull[i], hull[j]), squared_distance(hull[next(i)], hull[j])});
  }
  return largest;
}

// The largest distance between two points of a plane with the given normal: convex hull, then the
// antipodal pairs of its vertices, O(n log n); of few points all pairs, which take less time.
inline double planar_diameter(const std::vector<Indexed_surface::Point_3>& points,
                              const Indexed_surface::Vector_3& normal)
{
  using Point_2 = Exact_predicates_inexact_constructions_kernel::Point_2;
  using Vector_3 = Indexed_surface::Vector_3;
  const double x = std::abs(normal.x()), y = std::abs(normal.y()), z = std::abs(normal.z());
  const double size = (std::max)({x, y, z});
  if (points.empty() || !(size > 0))
    return 0;
  const Vector_3 n = normal / size; // the squares of its coordinates must not underflow
  Vector_3 u = cross_product(n, x <= (std::min)(y, z) ? Vector_3(1, 0, 0)
                                : y <= z              ? Vector_3(0, 1, 0)
                                                      : Vector_3(0, 0, 1));
  u = u / std::sqrt(u.squared_length());
  Vector_3 v = cross_product(n, u);
  v = v / std::sqrt(v.squared_length());
  std::vector<Point_2> projected, hull;
  projected.reserve(points.size());
  for (const Indexed_surface::Point_3& p : points)
    projected.emplace_back((p - points.front()) * u, (p - points.front()) * v);
  constexpr std::size_t few_points = 64; // two thousand pairs, a microsecond or two
  if (projected.size() <= few_points)
    return std::sqrt(largest_squared_distance(projected));
  convex_hull_2(projected.begin(), projected.end(), std::back_inserter(hull));

  // the ends of nearly collinear points, whose hull is so thin that rounding misleads the walk below
  double largest = 0;
  for (int axis : {0, 1})
  {
    const auto ends = std::minmax_element(
      hull.begin(), hull.end(), [axis](const Point_2& p, const Point_2& q) { return p[axis] < q[axis]; });
    largest = (std::max)(largest, squared_distance(*ends.first, *ends.second));
  }
  return std::sqrt((std::max)(largest, largest_squared_distance_of_antipodal_pairs(hull)));
}

// Sections of a surface by planes, found by walking over the faces that a plane crosses. A connected
// component of a section costs time linear in its length, whatever the size of the surface. A copy, for another thread,
// takes a bit for each face.
class Plane_section
{
public:
  using Index = Indexed_surface::Index;
  using Point_3 = Indexed_surface::Point_3;

  explicit Plane_section(const Indexed_surface& surface)
    : m_surface(surface),
      m_is_visited(surface.number_of_faces(), false)
  {}

  // Forgets which faces were visited: to be called before the first component of each plane.
  void start()
  {
    for (const Index face : m_visited)
      m_is_visited[face] = false;
    m_visited.clear();
  }

  // Adds to `points` where the plane crosses the edges of the component through `face`, each edge once; adds
  // nothing if the plane does not cross the face or the component was visited since the last call to start().
  void component(Index face, const Section_plane& plane, std::vector<Point_3>& points)
  {
    m_queue.assign(1, face);
    while (!m_queue.empty())
    {
      const Index f = m_queue.back();
      m_queue.pop_back();
      if (m_is_visited[f])
        continue;
      m_is_visited[f] = true;
      m_visited.push_back(f);
      cross_face(f, plane, points);
    }
  }

private:
  // A vertex on the plane counts as above, so that every edge is crossed or not and no case is degenerate.
  void cross_face(Index f, const Section_plane& plane, std::vector<Point_3>& points)
  {
    const Point_3* p = &m_surface.point(m_surface.vertex(m_surface.first_corner(f)));
    double height = plane.height(*p);
    const double first_height = height;
    for (Index c = m_surface.first_corner(f); c < m_surface.first_corner(f + 1); ++c)
    {
      const Index next = m_surface.next_corner(f, c);
      const Point_3* q = &m_surface.point(m_surface.vertex(next));
      const double next_height = next == m_surface.first_corner(f) ? first_height : plane.height(*q);
      if ((height >= 0) != (next_height >= 0) && enter(m_surface.neighbor(c)))
        points.push_back(*p + (*q - *p) * (height / (height - next_height)));
      p = q;
      height = next_height;
    }
  }

  // Whether the face beyond a crossed edge is still to be visited, or there is none: else the edge was
  // crossed from there.
  bool enter(Index neighbor)
  {
    if (neighbor == Indexed_surface::no_face())
      return true;
    if (m_is_visited[neighbor])
      return false;
    m_queue.push_back(neighbor);
    return true;
  }

  const Indexed_surface& m_surface;
  std::vector<bool> m_is_visited; // since the last start
  std::vector<Index> m_visited;
  std::vector<Index> m_queue;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_HISTOGRAM_METHOD_PLANE_SECTION_H
