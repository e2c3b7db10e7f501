// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CONNECTOR_PLACER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CONNECTOR_PLACER_H

#include <CGAL/Protrusion_segmentation/Connector.h>
#include <CGAL/Protrusion_segmentation/Connector_options.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Connected_caps.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Obstacles.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/Connectors/Seen_cap.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/bounding_ball.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal::connectors {

// Shares of the radius of a peg: walls of solids around sockets are thick enough to hold, pegs long enough to guide. Defaults are
// shares of the size. All are own choices, in the range of what slicers offer.
constexpr double thinnest_wall = 0.25, shortest_peg = 0.5, default_tolerance = 0.05;
constexpr double default_smallest_radius = 0.01;

// Where there is no room for a peg, thinner ones are tried.
constexpr double shares_of_radius[] = {1, 0.75, 0.5};

// Puts pegs and sockets on caps, the largest cap first.
class Connector_placer
{
public:
  using Placed = Connector<Point>;

  // `scale` is what a length of the user is multiplied by to be one among the points.
  Connector_placer(const Mesh_to_close& mesh,
                   const std::vector<std::size_t>& segment_of_face,
                   const Capper& capper,
                   const Connector_options& options,
                   double scale,
                   std::vector<Point>& points)
    : m_capper(capper),
      m_options(options),
      m_points(points),
      m_obstacles(mesh, segment_of_face, points)
  {
    if (options.tolerance)
      m_tolerance = *options.tolerance * scale;
    m_smallest_radius = options.smallest_radius ? *options.smallest_radius * scale
                                                : default_smallest_radius * bounding_ball(points).radius;
  }

  // Of each cap.
  std::vector<Placed> place(std::vector<Flat_cap>& caps)
  {
    std::vector<Seen_cap> seen;
    std::set<std::pair<std::size_t, Triangle>> uses;
    for (std::size_t c = 0; c < caps.size(); ++c)
    {
      seen.push_back(see_cap(caps[c].loop, m_points));
      m_obstacles.add(c, caps[c], caps[c].of_parent);
      for (const Triangle& triangle : caps[c].of_parent)
      {
        uses.emplace(caps[c].parent, triangle);
        uses.emplace(caps[c].segment, turned_over(triangle));
      }
    }
    const auto is_alone = [&](const Flat_cap& cap)
    {
      return std::none_of(cap.of_parent.begin(), cap.of_parent.end(),
                          [&](const Triangle& triangle)
                          {
                            return uses.count({cap.parent, turned_over(triangle)}) > 0 ||
                                   uses.count({cap.segment, triangle}) > 0;
                          });
    };
    std::vector<std::size_t> order(caps.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b)
                     { return seen[a].circle.radius > seen[b].circle.radius; });
    std::vector<Placed> result(caps.size());
    for (const std::size_t c : order)
    {
      result[c].segment = caps[c].segment;
      result[c].parent = caps[c].parent;
      result[c].cap_radius = seen[c].circle.radius;
      result[c].status = Connector_status::CAP_NOT_FLAT;
      if (seen[c].circle.radius > 0 && is_alone(caps[c]))
        place(c, seen[c], caps[c], result[c]);
    }
    return result;
  }

private:
  void place(std::size_t c, const Seen_cap& seen, Flat_cap& cap, Placed& result)
  {
    m_obstacles.look_from(c, seen.frame);
    std::optional<Connector_status> first_problem;
    for (const double share : shares_of_radius)
    {
      result.status = try_to_place(share, c, seen, cap, result);
      if (result.status == Connector_status::PLACED || result.status == Connector_status::CAP_NOT_FLAT)
        return;
      if (!first_problem)
        first_problem = result.status;
    }
    result.status = *first_problem;
  }

  Prism prism_in(const Seen_cap& seen, double share) const
  {
    const auto squared_distance = [&](const Point_2& p)
    { return (p - seen.circle.center).squared_length(); };
    const Point_2 farthest = *std::max_element(seen.loop.begin(), seen.loop.end(),
                                               [&](const Point_2& p, const Point_2& q)
                                               { return squared_distance(p) < squared_distance(q); });
    const double radius = share * m_options.radius * seen.circle.radius;
    return {m_options.number_of_sides,
            seen.circle.center,
            std::atan2(farthest.y() - seen.circle.center.y(), farthest.x() - seen.circle.center.x()),
            radius,
            share * m_options.depth * seen.circle.radius,
            0,
            m_tolerance ? *m_tolerance : default_tolerance * radius};
  }

  Connector_status try_to_place(double share,
                                std::size_t c,
                                const Seen_cap& seen,
                                Flat_cap& cap,
                                Placed& result)
  {
    Prism prism = prism_in(seen, share);
    const double wall = thinnest_wall * prism.radius;
    const std::vector<Point_2> base = prism.corners(prism.apothem() + prism.tolerance + wall);
    if (prism.radius < m_smallest_radius || !(prism.radius > 0) ||
        (base.front() - seen.circle.center).squared_length() > seen.circle.radius * seen.circle.radius)
      return Connector_status::CAP_TOO_SMALL;
    if (!m_obstacles.is_in_solid(seen.circle.center))
      return Connector_status::NO_ROOM;
    const Room room = m_obstacles.room_along(base);
    const auto depth_on_side = [&](double height, double behind)
    { return behind > wall ? (std::min)(prism.depth, height - wall - prism.tolerance) : 0.; };
    const double above = depth_on_side(room.above, room.below),
                 below = depth_on_side(room.below, room.above);
    const bool is_up = above > below; // the parent is below
    prism.depth = (std::max)(above, below);
    if (!(prism.depth >= shortest_peg * prism.radius))
      return Connector_status::NO_ROOM;
    prism.chamfer = (std::min)(m_options.chamfer * prism.radius,
                               (std::min)(prism.apothem(), prism.depth) / 2);
    return build(c, seen, prism, is_up, cap, result) ? Connector_status::PLACED
                                                     : Connector_status::CAP_NOT_FLAT;
  }

  // Divides triangles of a cap that cut obstacles, until they cut no more of those of either part than the flat cap does. Leaves
  // all as it was if that does not help.
  bool build(std::size_t c,
             const Seen_cap& seen,
             const Prism& prism,
             bool is_up,
             Flat_cap& cap,
             Placed& result)
  {
    constexpr int most_rounds = 8, most_vain_rounds = 2;
    const std::set<Edge> own_edges = edges_of(cap.of_parent);
    const auto is_taken = [&](std::size_t v, std::size_t w)
    {
      const Edge edge = std::minmax(v, w);
      return m_new_edges.count(edge) > 0 || (m_capper.is_edge(edge) && own_edges.count(edge) == 0);
    };
    const Number_of_cuts most_cuts = sum(m_obstacles.numbers_of_cuts(cap, cap.of_parent));
    for (std::vector<Point> points_between :
         {std::vector<Point>(), points_halfway(cap.loop, seen, prism, m_points)})
    {
      const std::size_t number_of_points = m_points.size();
      std::size_t least_number = (std::numeric_limits<std::size_t>::max)();
      for (int round = 0, vain_rounds = 0; round < most_rounds && vain_rounds < most_vain_rounds; ++round)
      {
        const Connected_caps built(seen.frame, cap.loop, seen.loop, prism, is_up, points_between,
                                   is_taken, m_points);
        const std::vector<Number_of_cuts> cuts = m_obstacles.numbers_of_cuts(cap, built.between());
        const Number_of_cuts number = sum(cuts);
        if (number.is_at_most(most_cuts))
        {
          use(c, seen, prism, is_up, built, cap, result);
          return true;
        }
        for (std::size_t i = 0; i < cuts.size(); ++i)
          if (cuts[i].all > 0)
            points_between.push_back(point_between(built.between()[i], seen.frame));
        m_points.resize(number_of_points);
        if (number.all / 2 > least_number)
          break; // it gets worse
        vain_rounds = number.all < least_number ? 0 : vain_rounds + 1;
        least_number = (std::min)(least_number, number.all);
      }
    }
    return false;
  }

  static Number_of_cuts sum(const std::vector<Number_of_cuts>& numbers)
  {
    Number_of_cuts result;
    for (const Number_of_cuts& number : numbers)
      result += number;
    return result;
  }

  // In the middle of the triangle, but in the solid.
  Point point_between(const Triangle& triangle, const Cap_frame& frame) const
  {
    const Point middle = frame.to_local(
      CGAL::centroid(m_points[triangle[0]], m_points[triangle[1]], m_points[triangle[2]]));
    return Point(middle.x(), middle.y(), m_obstacles.height_in_solid(middle));
  }

  void use(std::size_t c,
           const Seen_cap& seen,
           const Prism& prism,
           bool is_up,
           const Connected_caps& built,
           Flat_cap& cap,
           Placed& result)
  {
    m_obstacles.add(c, cap, built.with_peg());
    m_obstacles.add(c, cap, built.with_socket());
    m_new_edges.merge(edges_of(built.between()));
    cap.of_parent = is_up ? built.with_peg() : built.with_socket();
    cap.of_segment = is_up ? built.with_socket() : built.with_peg();
    std::transform(cap.of_segment.begin(), cap.of_segment.end(), cap.of_segment.begin(), turned_over);
    result.is_peg_on_segment = !is_up;
    const auto on_axis = [&](double height)
    { return seen.frame.to_world(Point(prism.center.x(), prism.center.y(), is_up ? height : -height)); };
    result.base = on_axis(0);
    result.end = on_axis(prism.depth);
    result.radius = prism.radius;
    result.depth = prism.depth;
    result.tolerance = prism.tolerance;
  }

  const Capper& m_capper;
  const Connector_options& m_options;
  std::vector<Point>& m_points;
  Obstacles m_obstacles;
  std::optional<double> m_tolerance;
  double m_smallest_radius;
  std::set<Edge> m_new_edges;
};

} // namespace CGAL::Protrusion_segmentation::internal::connectors

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CONNECTORS_CONNECTOR_PLACER_H
