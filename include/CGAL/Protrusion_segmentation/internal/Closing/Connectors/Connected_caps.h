// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CONNECTED_CAPS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CONNECTED_CAPS_H

#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Prism.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Triangulation_between.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/parts_with_flat_caps.h>

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::connectors {

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
    const std::vector<Ring> peg = prism.rings_of_peg(), socket = prism.rings_of_socket();
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
