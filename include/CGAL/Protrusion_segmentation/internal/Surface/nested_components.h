// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed components that lie inside each other: walls of cavities, and solids that are turned inside out.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_NESTED_COMPONENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_NESTED_COMPONENTS_H

#include <CGAL/Protrusion_segmentation/internal/Surface/Index_groups.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Signed_volume.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Solid.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// How the components of a surface lie inside each other.
class Nested_components
{
public:
  using Index = Indexed_surface::Index;

  // Coordinates are at most 1. `component` is that of every face.
  Nested_components(const Surface_arrays& surface,
                    const std::vector<Index>& component,
                    std::size_t number)
    : m_surface(surface),
      m_faces(component, number),
      m_orientation(number, 0),
      m_volume(number, 0),
      m_around(number),
      m_wall(number)
  {
    for (Index c = 0; c < number; ++c)
    {
      m_wall[c] = c;
      measure(c);
    }
    find_components_around();
    find_walls();
  }

  boost::iterator_range<const Index*> faces(Index c) const { return m_faces[c]; }

  // For each component: that whose wall it belongs to, if it is the wall of a cavity, or itself.
  const std::vector<Index>& walls() const { return m_wall; }

  // Is a closed component turned inside out? A wall of a cavity is if the component around it is.
  bool is_inside_out(Index c) const
  {
    return (orientation_in_whole(c) < 0 && m_wall[c] == c) != (m_orientation[outermost(c)] < 0);
  }

private:
  using Box = Box_intersection_d::Box_with_info_d<double, 3, Index>;

  // An open component has no orientation.
  void measure(Index c)
  {
    Signed_volume volume;
    for (const Index f : m_faces[c])
    {
      volume.add(Corners_of_face<Surface_arrays>{m_surface, f});
      for (Index corner = m_surface.first_corner(f); corner < m_surface.first_corner(f + 1); ++corner)
        if (m_surface.neighbor(corner) == Indexed_surface::no_face())
          return;
    }
    m_orientation[c] = volume.orientation();
    m_volume[c] = std::abs(volume.volume());
  }

  // Without components that look inward beside others that look outward there is nothing to be found.
  void find_components_around()
  {
    const auto begin = m_orientation.begin(), end = m_orientation.end();
    if (std::find(begin, end, 1) == end || std::find(begin, end, -1) == end)
      return;
    std::vector<Box> boxes;
    for (Index c = 0; c < m_orientation.size(); ++c)
      if (m_orientation[c] != 0)
        boxes.emplace_back(box_of(c), c);
    box_self_intersection_d(boxes.begin(), boxes.end(),
                            [&](const Box& a, const Box& b)
                            {
                              const bool is_a_larger = m_volume[a.info()] > m_volume[b.info()];
                              const auto& [larger, smaller] = is_a_larger ? std::tie(a, b) : std::tie(b, a);
                              const Bbox_3 box = larger.bbox();
                              if (box + smaller.bbox() == box)
                                m_around[larger.info()].push_back(smaller.info());
                            });
    std::vector<std::vector<Index>> inside = std::exchange(
      m_around, std::vector<std::vector<Index>>(m_around.size()));
    for (Index c = 0; c < inside.size(); ++c)
      if (!inside[c].empty())
        find_components_inside(c, inside[c]);
  }

  // Of some that may be. Their corners may touch the solid, but not all of them.
  void find_components_inside(Index c, const std::vector<Index>& others)
  {
    std::vector<Indexed_surface::Point_3> corners;
    std::vector<std::size_t> first = {0}; // of the corners of each
    for (const Index other : others)
    {
      add_some_corners(other, corners);
      first.push_back(corners.size());
    }
    const std::vector<Bounded_side> sides = Solid(m_surface, m_faces[c]).sides(corners);
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      const auto begin = sides.begin() + std::ptrdiff_t(first[i]), end = sides.begin() + std::ptrdiff_t(first[i + 1]);
      if (std::find(begin, end, ON_UNBOUNDED_SIDE) == end && std::find(begin, end, ON_BOUNDED_SIDE) != end)
        m_around[others[i]].push_back(c);
    }
  }

  Bbox_3 box_of(Index c) const
  {
    Bbox_3 box;
    for (const Index f : m_faces[c])
      for (Index corner = m_surface.first_corner(f); corner < m_surface.first_corner(f + 1); ++corner)
        box += m_surface.point(m_surface.vertex(corner)).bbox();
    return box;
  }

  void add_some_corners(Index c, std::vector<Indexed_surface::Point_3>& corners) const
  {
    constexpr std::size_t enough = 256;
    const std::size_t step = 1 + m_faces[c].size() / enough;
    for (std::size_t i = 0; i < m_faces[c].size(); i += step)
      corners.push_back(m_surface.point(m_surface.vertex(m_surface.first_corner(*(m_faces[c].begin() + std::ptrdiff_t(i))))));
  }

  Index outermost(Index c) const
  {
    const std::vector<Index>& around = m_around[c];
    return around.empty()
             ? c
             : *std::max_element(around.begin(), around.end(),
                                 [&](Index a, Index b) { return m_volume[a] < m_volume[b]; });
  }

  // Outward or inward, if the outermost component looks outward.
  int orientation_in_whole(Index c) const { return m_orientation[c] * m_orientation[outermost(c)]; }

  // What looks inward is the wall of a cavity if there is material around it.
  void find_walls()
  {
    for (Index c = 0; c < m_around.size(); ++c)
    {
      if (orientation_in_whole(c) >= 0)
        continue;
      int depth = 0; // of solids around it, less the cavities
      Index solid = c;
      for (const Index other : m_around[c])
      {
        depth += orientation_in_whole(other);
        if (orientation_in_whole(other) > 0 && (solid == c || m_volume[other] < m_volume[solid]))
          solid = other;
      }
      if (depth > 0)
        m_wall[c] = solid;
    }
  }

  const Surface_arrays& m_surface;
  Index_groups m_faces; // of each component
  std::vector<int> m_orientation;
  std::vector<double> m_volume;
  std::vector<std::vector<Index>> m_around; // for each component: those that it lies inside of
  std::vector<Index> m_wall;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_SURFACE_NESTED_COMPONENTS_H
