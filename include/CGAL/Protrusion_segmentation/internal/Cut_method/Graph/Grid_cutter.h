// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRID_CUTTER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRID_CUTTER_H

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// Cuts polygons by the planes of a grid: those of one axis after the other, the lowest first. So slivers that lie side by side are
// cut along the same lines, and an edge is cut in the same places whatever polygon it belongs to: pieces fit together. A vertex of
// the surface that lies near a plane lies on it, lest pieces be narrow.
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
  Grid_cutter(std::vector<Point_3> points, double cell)
    : m_points(std::move(points)), m_vertices_of_surface(m_points.size()), m_cell(cell)
  {}

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
  void cut_edge(Index from, Index to, Visit visit, int axis = 0)
  {
    for (; axis < 3; ++axis)
      if (const std::optional<double> plane = lowest_plane(std::array{Corner{from, 0}, Corner{to, 0}}, axis))
      {
        const bool begins_below = m_points[from][axis] < *plane;
        const Index vertex = vertex_on_plane(from, to, axis, *plane);
        cut_edge(from, vertex, visit, begins_below ? axis + 1 : axis);
        return cut_edge(vertex, to, visit, begins_below ? axis : axis + 1);
      }
    visit(from);
  }

private:
  // What lies nearer to a plane than this lies on it.
  double tolerance(Index vertex) const
  {
    constexpr double of_surface = 0.25, of_edges = 1e-6; // in cells: lines across edges stay straight
    return (vertex < m_vertices_of_surface ? of_surface : of_edges) * m_cell;
  }

  // The lowest plane with corners on both sides. None leads through the centre, where a flat sheet lies.
  template <typename Corners>
  std::optional<double> lowest_plane(const Corners& corners, int axis) const
  {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const Corner& corner : corners)
    {
      lowest = (std::min)(lowest, m_points[corner.vertex][axis] + tolerance(corner.vertex));
      highest = (std::max)(highest, m_points[corner.vertex][axis] - tolerance(corner.vertex));
    }
    const auto height = [this](double number) { return (number + 0.5) * m_cell; };
    double number = std::floor(lowest / m_cell - 0.5);
    while (height(number) <= lowest)
      ++number;
    return height(number) < highest ? std::optional<double>(height(number)) : std::nullopt;
  }

  // Of each corner: -1 below a plane, 1 above, 0 on it. Those on it between two corners on one side lie on that side, too.
  std::vector<int> sides(const Polygon& polygon, int axis, double plane) const
  {
    const std::size_t n = polygon.size();
    std::vector<int> result(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      const double height = m_points[polygon[i].vertex][axis] - plane,
                   of_plane = tolerance(polygon[i].vertex);
      result[i] = height > of_plane ? 1 : height < -of_plane ? -1 : 0;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      std::size_t before = i, after = i;
      while (result[before] == 0)
        before = (before + n - 1) % n;
      while (result[after] == 0)
        after = (after + 1) % n;
      if (result[before] == result[after])
        result[i] = result[before];
    }
    return result;
  }

  // What lies below a plane and above it.
  std::pair<Polygon, Polygon> halves(Index face, const Polygon& polygon, int axis, double plane)
  {
    const std::size_t n = polygon.size();
    const std::vector<int> side = sides(polygon, axis, plane);
    Polygon below, above;
    for (std::size_t i = 0; i < n; ++i)
    {
      const Corner& corner = polygon[i];
      const int before = side[(i + n - 1) % n], here = side[i], after = side[(i + 1) % n];
      if (here <= 0)
        below.push_back({corner.vertex, here == 0 && after > 0 ? face : corner.beyond});
      if (here > 0 || (here == 0 && (before > 0 || after > 0)))
        above.push_back({corner.vertex, here == 0 && after <= 0 ? face : corner.beyond});
      if (here * after < 0)
      {
        const Index vertex = vertex_on_plane(corner.vertex, polygon[(i + 1) % n].vertex, axis, plane);
        below.push_back({vertex, after > 0 ? face : corner.beyond});
        above.push_back({vertex, after < 0 ? face : corner.beyond});
      }
    }
    return {below, above};
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
  std::size_t m_vertices_of_surface;
  double m_cell;
  std::map<std::pair<Index, Index>, Index> m_on_planes; // where edges are cut first, by their vertices
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_GRAPH_GRID_CUTTER_H
