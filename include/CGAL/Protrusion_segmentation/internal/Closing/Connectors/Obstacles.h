// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_OBSTACLES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_OBSTACLES_H

#include <CGAL/Protrusion_segmentation/internal/Closing/Capper.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Cap_frame.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/parts_with_flat_caps.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::connectors {

// The part of a convex polygon where a * x + b * y <= c.
inline std::vector<Point> clipped(const std::vector<Point>& polygon, double a, double b, double c)
{
  std::vector<Point> result;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double above_p = a * p.x() + b * p.y() - c, above_q = a * q.x() + b * q.y() - c;
    if (above_p <= 0)
      result.push_back(p);
    if ((above_p < 0 && above_q > 0) || (above_p > 0 && above_q < 0))
      result.push_back(p + above_p / (above_p - above_q) * (q - p));
  }
  return result;
}

// Do two triangles meet elsewhere than in the vertices and the edge that they share? The vertices are numbers of points.
inline bool cut_each_other(Triangle s, Triangle t, const std::vector<Point>& points)
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto shared_first = [](Triangle& triangle, const Triangle& other)
  {
    return std::size_t(std::partition(triangle.begin(), triangle.end(),
                                      [&](std::size_t v) {
                                        return std::find(other.begin(), other.end(), v) != other.end();
                                      }) -
                       triangle.begin());
  };
  const std::size_t number_of_shared = shared_first(s, t);
  shared_first(t, s);
  const auto point = [&](std::size_t v)
  { return Exact::Point_3(points[v].x(), points[v].y(), points[v].z()); };
  const Exact::Point_3 a = point(s[0]), b = point(s[1]), c = point(s[2]), d = point(t[0]),
                       e = point(t[1]), f = point(t[2]);
  const Exact::Triangle_3 first(a, b, c), second(d, e, f);
  if (first.is_degenerate() || second.is_degenerate())
    return number_of_shared < 2;
  if (number_of_shared == 0)
    return CGAL::do_intersect(first, second);
  if (number_of_shared == 1)
    return CGAL::do_intersect(Exact::Segment_3(b, c), second) ||
           CGAL::do_intersect(Exact::Segment_3(e, f), first);
  return number_of_shared == 3 || (CGAL::orientation(a, b, c, f) == CGAL::COPLANAR &&
                                   CGAL::coplanar_orientation(a, b, c, f) == CGAL::POSITIVE);
}

// How far it is from a cap to the next obstacle on either side.
struct Room
{
  double above = (std::numeric_limits<double>::max)(), below = above;

  void add(double low, double high)
  {
    if (low > 0)
      above = (std::min)(above, low);
    else if (high < 0)
      below = (std::min)(below, -high);
    else
      above = below = 0;
  }
};

// How many obstacles are cut, those of a segment and of its parent among them.
struct Number_of_cuts
{
  std::size_t all = 0, of_segment = 0, of_parent = 0;

  Number_of_cuts& operator+=(const Number_of_cuts& other)
  {
    all += other.all;
    of_segment += other.of_segment;
    of_parent += other.of_parent;
    return *this;
  }
  bool is_at_most(const Number_of_cuts& other) const
  {
    return all <= other.all && of_segment <= other.of_segment && of_parent <= other.of_parent;
  }
};

// The triangles of a mesh, its caps and their connectors.
class Obstacles
{
public:
  // `points` may grow.
  Obstacles(const Mesh_to_close& mesh,
            const std::vector<std::size_t>& segment_of_face,
            const std::vector<Point>& points)
    : m_points(points)
  {
    for (const auto f : faces(mesh))
    {
      std::vector<std::size_t> corners;
      for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
        corners.push_back(std::size_t(v));
      for (std::size_t i = 2; i < corners.size(); ++i)
        m_triangles.push_back({corners[0], corners[i - 1], corners[i]});
      m_parts_of_triangle.resize(m_triangles.size(), {segment_of_face[f], segment_of_face[f]});
    }
    m_cap_of_triangle.assign(m_triangles.size(), no_cap);
  }

  // Of a cap between a segment and its parent.
  void add(std::size_t cap, const Flat_cap& parts, const std::vector<Triangle>& triangles)
  {
    m_triangles.insert(m_triangles.end(), triangles.begin(), triangles.end());
    m_cap_of_triangle.resize(m_triangles.size(), cap);
    m_parts_of_triangle.resize(m_triangles.size(), {parts.segment, parts.parent});
  }

  // All questions are about this cap from here on, whose own triangles are in no way.
  void look_from(std::size_t cap, const Cap_frame& frame)
  {
    m_cap = cap;
    m_frame = &frame;
    m_local.clear();
    for (const Point& p : m_points)
      m_local.push_back(frame.to_local(p));
    m_number_of_old_points = m_points.size();
  }

  // Along an upright prism with the convex polygon as its base, which runs counterclockwise.
  Room room_along(const std::vector<Point_2>& base) const
  {
    const Bbox_2 box = bbox_2(base.begin(), base.end());
    Room room;
    for_each_other(
      [&](std::size_t t, const Bbox_3& bounds)
      {
        const Triangle& triangle = m_triangles[t];
        if (bounds.xmin() > box.xmax() || bounds.xmax() < box.xmin() || bounds.ymin() > box.ymax() ||
            bounds.ymax() < box.ymin())
          return;
        std::vector<Point> part = {m_local[triangle[0]], m_local[triangle[1]], m_local[triangle[2]]};
        for (std::size_t i = 0; i < base.size() && !part.empty(); ++i)
        {
          const auto side = base[(i + 1) % base.size()] - base[i];
          part = clipped(part, side.y(), -side.x(), side.y() * base[i].x() - side.x() * base[i].y());
        }
        if (part.empty())
          return;
        const auto [low, high] = std::minmax_element(
          part.begin(), part.end(), [](const Point& p, const Point& q) { return p.z() < q.z(); });
        room.add(low->z(), high->z());
      });
    return room;
  }

  // Does the line through a point of the cap leave a solid on either side?
  bool is_in_solid(const Point_2& p) const
  {
    double above = (std::numeric_limits<double>::max)(), below = above;
    bool is_good_above = false, is_good_below = false;
    for_each_crossing(p,
                      [&](double height, bool is_left)
                      {
                        if (height >= 0 && height < above)
                        {
                          above = height;
                          is_good_above = is_left;
                        }
                        if (height <= 0 && -height < below)
                        {
                          below = -height;
                          is_good_below = !is_left;
                        }
                      });
    return is_good_above && is_good_below;
  }

  // The numbers of obstacles that each of the triangles of a cap cuts or lies on. Their points may be new.
  std::vector<Number_of_cuts> numbers_of_cuts(const Flat_cap& cap, const std::vector<Triangle>& triangles)
  {
    m_local.resize((std::min)(m_local.size(), m_number_of_old_points));
    for (std::size_t i = m_local.size(); i < m_points.size(); ++i)
      m_local.push_back(m_frame->to_local(m_points[i]));
    std::vector<Bbox_3> boxes;
    Bbox_3 whole;
    for (const Triangle& triangle : triangles)
    {
      boxes.push_back(box_of(triangle));
      whole += boxes.back();
    }
    std::vector<Number_of_cuts> result(triangles.size());
    for_each_other(
      [&](std::size_t t, const Bbox_3& box)
      {
        if (!do_overlap(box, whole))
          return;
        const auto& parts = m_parts_of_triangle[t];
        const auto is_of = [&](std::size_t part)
        { return std::size_t(parts[0] == part || parts[1] == part ? 1 : 0); };
        for (std::size_t i = 0; i < triangles.size(); ++i)
          if (do_overlap(box, boxes[i]) && cut_each_other(triangles[i], m_triangles[t], m_points))
            result[i] += {1, is_of(cap.segment), is_of(cap.parent)};
      });
    return result;
  }

  // The nearest height over the point, given in the frame, that is well inside of a solid.
  double height_in_solid(const Point& p) const
  {
    constexpr double margin = 0.25;   // of the thickness there
    std::map<double, bool> crossings; // with whether the solid is left upwards
    for_each_crossing(Point_2(p.x(), p.y()),
                      [&](double height, bool is_left) { crossings.emplace(height, is_left); });
    double best = p.z(), least_step = (std::numeric_limits<double>::max)();
    for (auto top = crossings.begin(); top != crossings.end(); ++top)
      if (top->second && top != crossings.begin() && !std::prev(top)->second)
      {
        const double low = std::prev(top)->first, high = top->first, space = margin * (high - low);
        const double height = (std::min)((std::max)(p.z(), low + space), high - space);
        if (std::abs(height - p.z()) < least_step)
        {
          least_step = std::abs(height - p.z());
          best = height;
        }
      }
    return best;
  }

private:
  static constexpr std::size_t no_cap = (std::numeric_limits<std::size_t>::max)();

  Bbox_3 box_of(const Triangle& t) const
  {
    return m_local[t[0]].bbox() + m_local[t[1]].bbox() + m_local[t[2]].bbox();
  }

  // Calls `visit` with the height of each triangle of the mesh over a point, and whether it looks upwards.
  template <typename Visit>
  void for_each_crossing(const Point_2& p, const Visit& visit) const
  {
    constexpr double rounding = 1e-9; // a line through a vertex must not slip through between triangles
    const auto twice_area = [](const Point_2& q, const Point_2& r, const Point_2& s)
    { return (r.x() - q.x()) * (s.y() - q.y()) - (r.y() - q.y()) * (s.x() - q.x()); };
    for (std::size_t t = 0; t < m_triangles.size() && m_cap_of_triangle[t] == no_cap; ++t)
    {
      const Point &a = m_local[m_triangles[t][0]], &b = m_local[m_triangles[t][1]],
                  &c = m_local[m_triangles[t][2]];
      const Point_2 a2(a.x(), a.y()), b2(b.x(), b.y()), c2(c.x(), c.y());
      const double area = twice_area(a2, b2, c2);
      const double u = twice_area(p, b2, c2) / area, v = twice_area(a2, p, c2) / area, w = 1 - u - v;
      if (u >= -rounding && v >= -rounding && w >= -rounding) // not if there is no area
        visit(u * a.z() + v * b.z() + w * c.z(), area > 0);
    }
  }

  template <typename Visit>
  void for_each_other(const Visit& visit) const
  {
    for (std::size_t t = 0; t < m_triangles.size(); ++t)
      if (m_cap_of_triangle[t] != m_cap)
        visit(t, box_of(m_triangles[t]));
  }

  const std::vector<Point>& m_points;
  std::vector<Triangle> m_triangles; // those of the mesh first
  std::vector<std::size_t> m_cap_of_triangle;
  std::vector<std::array<std::size_t, 2>> m_parts_of_triangle; // the same twice for those of the mesh
  std::size_t m_cap = no_cap;
  const Cap_frame* m_frame = nullptr;
  std::vector<Point> m_local; // in the frame of the cap
  std::size_t m_number_of_old_points = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal::connectors

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_OBSTACLES_H
