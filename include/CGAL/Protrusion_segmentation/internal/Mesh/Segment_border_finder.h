// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_SEGMENT_BORDER_FINDER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_SEGMENT_BORDER_FINDER_H

#include <CGAL/Protrusion_segmentation/Segment_border.h>
#include <CGAL/Protrusion_segmentation/internal/user_points.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Walks along the edges between segments.
template <typename FaceGraph, typename SegmentMap, typename VertexPointMap>
class Segment_border_finder
{
public:
  using Halfedge = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Border = Segment_border<Point>;

  Segment_border_finder(const FaceGraph& mesh, const SegmentMap& segments, const VertexPointMap& points)
    : m_mesh(mesh), m_segments(segments), m_points(points), m_seen(get(dynamic_halfedge_property_t<bool>(), mesh))
  {
    for (const Halfedge h : halfedges(mesh))
      put(m_seen, h, false);
  }

  // sorted by the two segments
  std::vector<Border> find()
  {
    std::vector<Border> borders;
    for (const Halfedge h : halfedges(m_mesh))
      if (is_between_segments(h) && left(h) < right(h) && !get(m_seen, h))
        borders.push_back(border_along(first_of_line(h)));
    std::stable_sort(borders.begin(), borders.end(),
                     [](const Border& a, const Border& b) { return a.segments < b.segments; });
    return borders;
  }

private:
  bool is_inner(Halfedge h) const { return !is_border(h, m_mesh) && !is_border(opposite(h, m_mesh), m_mesh); }
  bool is_between_segments(Halfedge h) const { return is_inner(h) && left(h) != right(h); }
  std::size_t left(Halfedge h) const { return static_cast<std::size_t>(get(m_segments, face(h, m_mesh))); }
  std::size_t right(Halfedge h) const { return left(opposite(h, m_mesh)); }

  // Around a vertex in the segment on the left, from `h` on, to where it ends; `step` is the next or the previous
  // halfedge in a face. None if the line does not go on, for there is a third segment or the border of the mesh.
  template <typename Step>
  std::optional<Halfedge> neighbor_in_line(Halfedge h, const Step& step) const
  {
    Halfedge g = step(h);
    while (is_inner(g) && right(g) == left(h))
      g = step(opposite(g, m_mesh));
    if (!is_inner(g) || right(g) != right(h))
      return std::nullopt;
    return g;
  }
  std::optional<Halfedge> next_in_line(Halfedge h) const
  {
    return neighbor_in_line(h, [this](Halfedge g) { return next(g, m_mesh); });
  }

  // `h` itself in a closed line
  Halfedge first_of_line(Halfedge h) const
  {
    Halfedge first = h;
    while (const auto before = neighbor_in_line(first, [this](Halfedge g) { return prev(g, m_mesh); }))
    {
      first = *before;
      if (first == h)
        break;
    }
    return first;
  }

  double length(Halfedge h) const
  {
    const auto edge = to_double_point(get(m_points, target(h, m_mesh))) -
                      to_double_point(get(m_points, source(h, m_mesh)));
    return std::hypot(edge.x(), edge.y(), edge.z());
  }

  Border border_along(Halfedge first)
  {
    Border border;
    border.segments = {left(first), right(first)};
    border.points.push_back(get(m_points, source(first, m_mesh)));
    for (std::optional<Halfedge> h = first; h && !border.is_closed;)
    {
      put(m_seen, *h, true);
      border.length += length(*h);
      const Point& end = get(m_points, target(*h, m_mesh));
      h = next_in_line(*h);
      border.is_closed = h == first;
      if (!border.is_closed)
        border.points.push_back(end);
    }
    return border;
  }

  const FaceGraph& m_mesh;
  const SegmentMap& m_segments;
  const VertexPointMap& m_points;
  typename boost::property_map<FaceGraph, dynamic_halfedge_property_t<bool>>::const_type m_seen;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_MESH_SEGMENT_BORDER_FINDER_H
