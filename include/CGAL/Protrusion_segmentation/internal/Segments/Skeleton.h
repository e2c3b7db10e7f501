// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SKELETON_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SKELETON_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/Skeleton_joint.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A protrusion, by the number of the face at its tip.
struct Limb
{
  std::size_t segment;
  std::size_t parent;
  Indexed_surface::Index tip;
};

// The mean of points that weigh something.
class Weighted_mean
{
public:
  using Point = Indexed_surface::Point_3;

  void add(const Point& point, double weight)
  {
    m_sum += weight * (point - ORIGIN);
    m_plain_sum += point - ORIGIN;
    m_weight += weight;
    m_count += 1;
  }

  bool is_empty() const { return m_count == 0; }

  // Of points without weight all count the same.
  Point value() const { return ORIGIN + (m_weight > 0 ? m_sum / m_weight : m_plain_sum / m_count); }

private:
  Indexed_surface::Vector_3 m_sum{0, 0, 0}, m_plain_sum{0, 0, 0};
  double m_weight = 0, m_count = 0;
};

// The joints of a surface with segments, whose points are in a unit in which squares of areas are numbers.
class Skeleton
{
public:
  using Index = Indexed_surface::Index;
  using Point = Indexed_surface::Point_3;
  using Joint = Skeleton_joint<Point>;

  Skeleton(const Surface_arrays& surface,
           const std::vector<std::size_t>& segments,
           const std::vector<Limb>& limbs,
           std::size_t number_of_inner_joints)
    : m_surface(surface),
      m_segments(segments),
      m_limbs(limbs),
      m_number_of_inner_joints(number_of_inner_joints)
  {
    for (const std::size_t segment : segments)
      if (segment >= m_places.size())
        m_places.resize(segment + 1);
    for (const Limb& limb : limbs)
      m_places.resize((std::max)({m_places.size(), limb.segment + 1, limb.parent + 1}));
    for (Index face = 0; face < surface.number_of_faces(); ++face)
    {
      m_measures.push_back(measure_polygon(Corners_of_face<Surface_arrays>{surface, face}));
      m_places[segments[face]].faces.push_back(face);
    }
    for (std::size_t i = 0; i < limbs.size(); ++i)
    {
      m_places[limbs[i].parent].children.push_back(i);
      m_places[limbs[i].segment].is_body = false;
    }
    measure_levels();
    for (std::size_t segment = 0; segment < m_places.size(); ++segment)
      if (m_places[segment].is_body && !m_places[segment].faces.empty())
        add_body(segment);
  }

  // The parents first.
  const std::vector<Joint>& joints() const { return m_joints; }

private:
  struct Place // of a segment
  {
    std::vector<Index> faces;
    std::vector<std::size_t> children; // as numbers of limbs
    bool is_body = true;
    std::vector<std::pair<double, std::size_t>> levels; // of its joints that others hang on
  };

  double distance(const Point& p, const Point& q) const { return std::sqrt(squared_distance(p, q)); }

  // Calls `visit(face, neighbor, p, q)` for all edges between a segment and another one.
  template <typename Visit>
  void for_each_border_edge(std::size_t segment, std::size_t other, const Visit& visit) const
  {
    for (const Index face : m_places[segment].faces)
      for (Index c = m_surface.first_corner(face); c < m_surface.first_corner(face + 1); ++c)
      {
        const Index neighbor = m_surface.neighbor(c);
        if (neighbor == Indexed_surface::no_face() || m_segments[neighbor] != other)
          continue;
        const Index next = c + 1 < m_surface.first_corner(face + 1) ? c + 1
                                                                    : m_surface.first_corner(face);
        visit(face, neighbor, m_surface.point(m_surface.vertex(c)),
              m_surface.point(m_surface.vertex(next)));
      }
  }

  // For each face of a protrusion the distance from the border to the parent, over centroids of faces of the segment.
  void measure_levels()
  {
    using Offer = std::pair<double, Index>;
    m_levels.assign(m_segments.size(), std::numeric_limits<double>::infinity());
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
    for (const Limb& limb : m_limbs)
      for_each_border_edge(limb.segment, limb.parent,
                           [&](Index face, Index, const Point& p, const Point& q) {
                             offers.emplace(distance(m_measures[face].centroid, midpoint(p, q)), face);
                           });
    while (!offers.empty())
    {
      const auto [level, face] = offers.top();
      offers.pop();
      if (level >= m_levels[face])
        continue;
      m_levels[face] = level;
      for (Index c = m_surface.first_corner(face); c < m_surface.first_corner(face + 1); ++c)
        if (const Index next = m_surface.neighbor(c);
            next != Indexed_surface::no_face() && m_segments[next] == m_segments[face])
          offers.emplace(level + distance(m_measures[face].centroid, m_measures[next].centroid), next);
    }
  }

  std::size_t add_joint(const Point& point, std::size_t parent, std::size_t segment, bool is_tip = false)
  {
    m_joints.push_back({point, parent, segment, is_tip});
    return m_joints.size() - 1;
  }

  Point centroid(std::size_t segment) const
  {
    Weighted_mean mean;
    for (const Index face : m_places[segment].faces)
      mean.add(m_measures[face].centroid, m_measures[face].area);
    return mean.value();
  }

  // With all that sticks out of it, in the order of the limbs.
  void add_body(std::size_t segment)
  {
    const std::size_t root = add_joint(centroid(segment), m_joints.size(), segment);
    m_places[segment].levels.emplace_back(0, root);
    std::vector<std::size_t> open(m_places[segment].children.rbegin(), m_places[segment].children.rend());
    while (!open.empty())
    {
      const Limb& limb = m_limbs[open.back()];
      open.pop_back();
      add_limb(limb);
      const std::vector<std::size_t>& children = m_places[limb.segment].children;
      open.insert(open.end(), children.rbegin(), children.rend());
    }
  }

  void add_limb(const Limb& limb)
  {
    Place& place = m_places[limb.segment];
    if (place.faces.empty())
      return;
    Weighted_mean border, level_in_parent;
    for_each_border_edge(limb.segment, limb.parent,
                         [&](Index, Index neighbor, const Point& p, const Point& q)
                         {
                           border.add(midpoint(p, q), distance(p, q));
                           if (std::isfinite(m_levels[neighbor]))
                             level_in_parent.add(Point(m_levels[neighbor], 0, 0), distance(p, q));
                         });
    const Point at_border = border.is_empty() ? centroid(limb.segment) : border.value();
    const double level = level_in_parent.is_empty() ? 0 : level_in_parent.value().x();
    std::size_t last = add_joint(at_border, nearest_joint(limb.parent, level), limb.segment);
    place.levels.emplace_back(0, last);
    const double length = m_levels[limb.tip];
    for (std::size_t i = 1; i <= m_number_of_inner_joints && std::isfinite(length); ++i)
    {
      const double step = length / double(m_number_of_inner_joints + 1);
      const Weighted_mean band = mean_of_band(limb.segment, (double(i) - 0.5) * step,
                                              (double(i) + 0.5) * step);
      if (band.is_empty())
        continue;
      last = add_joint(band.value(), last, limb.segment);
      place.levels.emplace_back(double(i) * step, last);
    }
    add_joint(m_measures[limb.tip].centroid, last, limb.segment, true);
  }

  std::size_t nearest_joint(std::size_t segment, double level) const
  {
    const auto& levels = m_places[segment].levels;
    return std::min_element(levels.begin(), levels.end(),
                            [&](const auto& a, const auto& b)
                            { return std::abs(a.first - level) < std::abs(b.first - level); })
      ->second;
  }

  Weighted_mean mean_of_band(std::size_t segment, double from, double to) const
  {
    Weighted_mean mean;
    for (const Index face : m_places[segment].faces)
      if (m_levels[face] >= from && m_levels[face] < to)
        mean.add(m_measures[face].centroid, m_measures[face].area);
    return mean;
  }

  const Surface_arrays& m_surface;
  const std::vector<std::size_t>& m_segments; // of the faces
  const std::vector<Limb>& m_limbs;
  std::size_t m_number_of_inner_joints;
  std::vector<Polygon_measures> m_measures; // of the faces
  std::vector<double> m_levels;             // of the faces; infinite where there is none
  std::vector<Place> m_places;
  std::vector<Joint> m_joints;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SEGMENTS_SKELETON_H
