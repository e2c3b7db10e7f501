// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRID_CUTTER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRID_CUTTER_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Cuts polygons by the planes of a grid: those of one axis after the other, the lowest first. So slivers that lie side by side are
// cut along the same lines, and an edge is cut in the same places whatever polygon it belongs to: pieces fit together.
class Grid_cutter
{
public:
  using Index = Indexed_surface::Index;
  using Point_3 = Indexed_surface::Point_3;

  struct Corner
  {
    Index vertex, beyond; // the face beyond the edge to the next corner
  };
  using Polygon = std::vector<Corner>; // convex

  // `cell`: the distance of two planes, above 0
  Grid_cutter(std::vector<Point_3> points, double cell) : m_points(std::move(points)), m_cell(cell) {}

  // the vertices that there were, then those that have been added, by `add()` or where edges are cut
  std::vector<Point_3>& points() { return m_points; }

  Index add(const Point_3& point)
  {
    m_points.push_back(point);
    return static_cast<Index>(m_points.size() - 1);
  }

  // Calls `visit` for each piece of a polygon of a face. Beyond the edges between them is the face itself.
  template <typename Visit>
  void cut(Index face, Polygon polygon, Visit visit, int axis = 0)
  {
    for (; axis < 3; ++axis)
      while (const std::optional<double> plane = lowest_plane(polygon, axis))
      {
        auto [below, above] = halves(face, polygon, axis, *plane);
        cut(face, std::move(below), visit, axis + 1);
        polygon = std::move(above);
      }
    visit(polygon);
  }

  // Calls `visit` for the first vertex of each piece of an edge.
  template <typename Visit>
  void cut_edge(Index from, Index to, Visit visit)
  {
    std::vector<Index> ends(1, to); // of the pieces to come, the last one first
    while (!ends.empty())
      if (const std::optional<Index> vertex = first_vertex_on_plane(from, ends.back()))
        ends.push_back(*vertex);
      else
      {
        visit(from);
        from = ends.back();
        ends.pop_back();
      }
  }

private:
  // What lies nearer to a plane lies on it.
  double tolerance() const { return 1e-6 * m_cell; }

  // The lowest plane of the grid between two heights. None leads through the centre, where a flat sheet lies.
  std::optional<double> lowest_plane(double lowest, double highest) const
  {
    const auto height = [this](double number) { return (number + 0.5) * m_cell; };
    double number = std::floor(lowest / m_cell);
    while (height(number) - lowest <= tolerance())
      ++number;
    return highest - height(number) > tolerance() ? std::optional<double>(height(number)) : std::nullopt;
  }

  std::optional<double> lowest_plane(const Polygon& polygon, int axis) const
  {
    const auto is_lower = [&](const Corner& a, const Corner& b)
    { return m_points[a.vertex][axis] < m_points[b.vertex][axis]; };
    const auto [lowest, highest] = std::minmax_element(polygon.begin(), polygon.end(), is_lower);
    return lowest_plane(m_points[lowest->vertex][axis], m_points[highest->vertex][axis]);
  }

  // Of a plane: -1 below it, 1 above, 0 on it.
  int side(Index vertex, int axis, double plane) const
  {
    const double height = m_points[vertex][axis] - plane;
    return height > tolerance() ? 1 : height < -tolerance() ? -1 : 0;
  }

  // What lies below a plane and above it.
  std::pair<Polygon, Polygon> halves(Index face, const Polygon& polygon, int axis, double plane)
  {
    Polygon below, above;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const int from = side(a.vertex, axis, plane), to = side(b.vertex, axis, plane);
      if (from <= 0)
        below.push_back({a.vertex, from == 0 && to > 0 ? face : a.beyond});
      if (from >= 0)
        above.push_back({a.vertex, from == 0 && to < 0 ? face : a.beyond});
      if (from * to < 0)
      {
        const Index vertex = vertex_on_plane(a.vertex, b.vertex, axis, plane);
        below.push_back({vertex, to > 0 ? face : a.beyond});
        above.push_back({vertex, to < 0 ? face : a.beyond});
      }
    }
    return {below, above};
  }

  // Where an edge is cut first, if it is.
  std::optional<Index> first_vertex_on_plane(Index v, Index w)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto [lowest, highest] = std::minmax(m_points[v][axis], m_points[w][axis]);
      if (const std::optional<double> plane = lowest_plane(lowest, highest))
        return vertex_on_plane(v, w, axis, *plane);
    }
    return std::nullopt;
  }

  // Of an edge that no plane before this one cuts.
  Index vertex_on_plane(Index v, Index w, int axis, double plane)
  {
    const auto [found, is_new] = m_on_planes.try_emplace(std::minmax(v, w),
                                                         static_cast<Index>(m_points.size()));
    if (is_new)
    {
      const Point_3 &a = m_points[found->first.first], &b = m_points[found->first.second];
      const Point_3 p = a + (plane - a[axis]) / (b[axis] - a[axis]) * (b - a);
      m_points.emplace_back(axis == 0 ? plane : p.x(), axis == 1 ? plane : p.y(),
                            axis == 2 ? plane : p.z());
    }
    return found->second;
  }

  std::vector<Point_3> m_points;
  double m_cell;
  std::map<std::pair<Index, Index>, Index> m_on_planes; // where edges are cut first, by their vertices
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRID_CUTTER_H
