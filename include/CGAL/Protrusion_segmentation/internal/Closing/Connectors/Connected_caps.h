// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CONNECTED_CAPS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CONNECTED_CAPS_H

#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Cap_frame.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Prism.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/parts_with_flat_caps.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::connectors {

// Triangles between two polygons. Their corners are those of the outer one, of the inner one and, behind them, further points.
struct Triangles_between
{
  std::vector<Point_2> further_points;
  std::vector<std::array<std::size_t, 3>> triangles; // counterclockwise
};

class Triangulation_between
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Exact>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Exact>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Exact,
    CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
    CGAL::No_constraint_intersection_tag>;
  using Face_handle = Triangulation::Face_handle;

public:
  Triangulation_between(const std::vector<Point_2>& outer, const std::vector<Point_2>& inner)
    : m_number_outside(outer.size())
  {
    add_polygon(outer);
    add_polygon(inner);
  }

  // Between the polygons. These are the first of the further points.
  void add_point(const Point_2& p)
  {
    const std::size_t number_of_vertices = m_triangulation.number_of_vertices();
    const auto vertex = m_triangulation.insert(Exact::Point_2(p.x(), p.y()));
    if (m_triangulation.number_of_vertices() > number_of_vertices) // else there is one at that place
      vertex->info() = m_number_of_points;
    ++m_number_of_points;
    m_result.further_points.push_back(p);
  }

  // `is_taken(i, j)` says whether corners of the outer polygon must not be joined. A point divides such an edge.
  template <typename IsTaken>
  Triangles_between triangulate(const IsTaken& is_taken)
  {
    constexpr int most_rounds = 10; // one in practice
    for (int round = 0; round < most_rounds; ++round)
    {
      const std::vector<Exact::Point_2> middles = middles_of_taken_edges(is_taken);
      if (middles.empty())
        break;
      for (const Exact::Point_2& middle : middles)
      {
        m_result.further_points.emplace_back(middle.x(), middle.y());
        m_triangulation.insert(middle)->info() = m_number_of_points++;
      }
    }
    for (const Face_handle face : faces_between())
      m_result.triangles.push_back(
        {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    return m_result;
  }

private:
  void add_polygon(const std::vector<Point_2>& polygon)
  {
    std::vector<Triangulation::Vertex_handle> corners;
    for (const Point_2& p : polygon)
    {
      corners.push_back(m_triangulation.insert(Exact::Point_2(p.x(), p.y())));
      corners.back()->info() = m_number_of_points++;
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
      m_triangulation.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  }

  // Those that are reached from outside by one polygon.
  std::vector<Face_handle> faces_between() const
  {
    std::set<Face_handle> seen = {m_triangulation.infinite_face()};
    std::vector<Face_handle> outside = {m_triangulation.infinite_face()}, result;
    const auto add_neighbors = [&](std::vector<Face_handle>& faces, std::vector<Face_handle>* beyond)
    {
      for (std::size_t next = 0; next < faces.size(); ++next)
        for (int i = 0; i < 3; ++i)
        {
          const Face_handle face = faces[next], neighbor = face->neighbor(i);
          std::vector<Face_handle>* const place = face->is_constrained(i) ? beyond : &faces;
          if (place && seen.insert(neighbor).second)
            place->push_back(neighbor);
        }
    };
    add_neighbors(outside, &result);
    add_neighbors(result, nullptr);
    return result;
  }

  template <typename IsTaken>
  std::vector<Exact::Point_2> middles_of_taken_edges(const IsTaken& is_taken) const
  {
    std::vector<Exact::Point_2> middles;
    for (const Face_handle face : faces_between())
      for (int i = 0; i < 3; ++i)
      {
        const auto v = face->vertex(Triangulation::ccw(i)), w = face->vertex(Triangulation::cw(i));
        if (!face->is_constrained(i) && v->info() < w->info() && // once for both of its faces
            w->info() < m_number_outside && is_taken(v->info(), w->info()))
          middles.push_back(CGAL::midpoint(v->point(), w->point()));
      }
    return middles;
  }

  Triangulation m_triangulation;
  Triangles_between m_result;
  std::size_t m_number_outside, m_number_of_points = 0;
};

// A cap with a flat middle, from which a peg rises and a socket sinks, with the normals of the frame: those of the parent's
// side.
class Connected_caps
{
public:
  // New points are added to `points`, `points_between` among them, which are given in the frame. `is_up` says whether the peg is
  // on the parent and rises into the segment.
  // `is_taken(v, w)` says whether two vertices of the loop must not be joined.
  template <typename IsTaken>
  Connected_caps(const Cap_frame& frame,
                 const Loop& loop,
                 const std::vector<Point_2>& loop_in_frame,
                 const Prism& prism,
                 bool is_up,
                 const std::vector<Point>& points_between,
                 const IsTaken& is_taken,
                 std::vector<Point>& points)
    : m_frame(frame),
      m_prism(prism),
      m_sign(is_up ? 1 : -1),
      m_points(points)
  {
    const std::vector<Ring> peg = prism.rings_moved_by(0), socket = prism.rings_moved_by(prism.tolerance);
    const Loop foot = add_ring(socket.front());
    Triangulation_between triangulation(loop_in_frame, prism.corners(socket.front().apothem));
    for (const Point& p : points_between)
      triangulation.add_point(Point_2(p.x(), p.y()));
    add_triangles_between(
      loop, foot,
      triangulation.triangulate([&](std::size_t i, std::size_t j) { return is_taken(loop[i], loop[j]); }),
      points_between);
    m_with_peg = m_with_socket = m_between;
    if (prism.tolerance == 0)
    {
      add_rings(foot, peg, m_with_peg);
      m_with_socket = m_with_peg;
      return;
    }
    add_rings(foot, socket, m_with_socket);
    const Loop foot_of_peg = add_ring(peg.front());
    add_walls(foot, foot_of_peg, m_with_peg);
    add_rings(foot_of_peg, peg, m_with_peg);
  }

  // Around the socket.
  const std::vector<Triangle>& between() const { return m_between; }
  const std::vector<Triangle>& with_peg() const { return m_with_peg; }
  const std::vector<Triangle>& with_socket() const { return m_with_socket; }

private:
  std::size_t add_point(const Point_2& p, double height)
  {
    m_points.push_back(m_frame.to_world(Point(p.x(), p.y(), m_sign * height)));
    return m_points.size() - 1;
  }

  Loop add_ring(const Ring& ring)
  {
    Loop corners;
    for (const Point_2& p : m_prism.corners(ring.apothem))
      corners.push_back(add_point(p, ring.height));
    return corners;
  }

  void add_triangles_between(const Loop& loop,
                             const Loop& foot,
                             const Triangles_between& found,
                             const std::vector<Point>& points_between)
  {
    Loop corners = loop;
    corners.insert(corners.end(), foot.begin(), foot.end());
    for (std::size_t i = 0; i < found.further_points.size(); ++i)
      corners.push_back(add_point(found.further_points[i],
                                  i < points_between.size() ? m_sign * points_between[i].z() : 0));
    for (const auto& [a, b, c] : found.triangles)
      m_between.push_back(from_smallest({corners[a], corners[b], corners[c]}));
  }

  static void add_walls(const Loop& outer, const Loop& inner, std::vector<Triangle>& triangles)
  {
    for (std::size_t i = 0; i < outer.size(); ++i)
    {
      const std::size_t j = (i + 1) % outer.size();
      triangles.push_back(from_smallest({outer[i], outer[j], inner[j]}));
      triangles.push_back(from_smallest({outer[i], inner[j], inner[i]}));
    }
  }

  // From the first of the rings, which is there already, to the last, with its inside.
  void add_rings(const Loop& foot, const std::vector<Ring>& rings, std::vector<Triangle>& triangles)
  {
    Loop last = foot;
    for (std::size_t i = 1; i < rings.size(); ++i)
    {
      const Loop next = add_ring(rings[i]);
      add_walls(last, next, triangles);
      last = next;
    }
    for (std::size_t i = 2; i < last.size(); ++i)
      triangles.push_back(from_smallest({last[0], last[i - 1], last[i]}));
  }

  const Cap_frame& m_frame;
  const Prism& m_prism;
  double m_sign;
  std::vector<Point>& m_points;
  std::vector<Triangle> m_between, m_with_peg, m_with_socket;
};

} // namespace CGAL::Protrusion_segmentation::internal::connectors

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CONNECTED_CAPS_H
