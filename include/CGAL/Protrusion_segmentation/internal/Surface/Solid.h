// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SOLID_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SOLID_H

#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <array>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The triangles of a closed surface, to be asked which points are inside.
class Solid
{
public:
  using Index = Indexed_surface::Index;
  using Point_3 = Indexed_surface::Point_3;

  template <typename Faces>
  Solid(const Surface_arrays& surface, const Faces& faces)
  {
    for (const Index f : faces)
      for_each_triangle_of_fan(Corners_of_face<Surface_arrays>{surface, f},
                               [&](const Point_3& p, const Point_3& q, const Point_3& r) { m_triangles.push_back({p, q, r}); });
  }

  // Of each point. A ray upwards from a point inside crosses an odd number of triangles.
  std::vector<Bounded_side> sides(const std::vector<Point_3>& points) const
  {
    std::vector<Box> rays, boxes;
    Bbox_3 whole;
    for (const auto& [p, q, r] : m_triangles)
    {
      boxes.emplace_back(p.bbox() + q.bbox() + r.bbox(), Index(boxes.size()));
      whole += boxes.back().bbox();
    }
    for (const Point_3& p : points)
      rays.emplace_back(p.bbox() + Point_3(p.x(), p.y(), whole.zmax()).bbox(), Index(rays.size()));
    std::vector<Bounded_side> result(points.size(), ON_UNBOUNDED_SIDE);
    box_intersection_d(rays.begin(), rays.end(), boxes.begin(), boxes.end(),
                       [&](const Box& ray, const Box& box)
                       { pass(m_triangles[box.info()], points[ray.info()], result[ray.info()]); });
    return result;
  }

private:
  using Exact = Exact_predicates_inexact_constructions_kernel;
  using Box = Box_intersection_d::Box_with_info_d<double, 3, Index>;
  using Triangle = std::array<Point_3, 3>;

  // Updates the side of a point for one more triangle: on the boundary if it lies on it, the other side if it lies below.
  static void pass(const Triangle& triangle, const Point_3& point, Bounded_side& side)
  {
    const auto exact = [](const Point_3& t) { return Exact::Point_3(t.x(), t.y(), t.z()); };
    const Exact::Point_3 p = exact(triangle[0]), q = exact(triangle[1]), r = exact(triangle[2]), s = exact(point);
    if (side == ON_BOUNDARY || collinear(p, q, r))
      return;
    const Orientation height = orientation(p, q, r, s), turn = turn_from_above(p, q, s);
    const auto is_beside = [&](const Exact::Point_3& a, const Exact::Point_3& b, const Exact::Point_3& c)
    { return coplanar_orientation(a, b, c, s) == NEGATIVE; };
    if (height == COPLANAR && !is_beside(p, q, r) && !is_beside(q, r, p) && !is_beside(r, p, q))
      side = ON_BOUNDARY;
    else if (height == -turn && turn == turn_from_above(q, r, s) && turn == turn_from_above(r, p, s))
      side = opposite(side);
  }

  // Of three points in a plan. The last one is moved by the least along x, and by less along y, so that no ray meets an edge.
  static Orientation turn_from_above(const Exact::Point_3& p, const Exact::Point_3& q, const Exact::Point_3& r)
  {
    const auto plan = [](const Exact::Point_3& t) { return Exact::Point_2(t.x(), t.y()); };
    if (const Orientation turn = orientation(plan(p), plan(q), plan(r)); turn != COLLINEAR)
      return turn;
    return p.y() != q.y() ? CGAL::compare(p.y(), q.y()) : CGAL::compare(q.x(), p.x());
  }

  std::vector<Triangle> m_triangles;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_SOLID_H
