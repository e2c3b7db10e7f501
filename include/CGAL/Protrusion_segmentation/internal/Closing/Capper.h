// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CAPPER_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CAPPER_H

#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The mesh that is closed, a copy of the user's.
using Mesh_to_close = Surface_mesh<Simple_cartesian<double>::Point_3>;

using Loop = std::vector<std::size_t>;            // numbers of vertices
using Edge = std::pair<std::size_t, std::size_t>; // two vertices, the smaller one first
using Triangle = std::array<std::size_t, 3>;      // three vertices; in caps the smallest comes first

// For longer loops the search among all triangulations, in cubic time, takes longer than a second.
constexpr std::size_t longest_loop_for_cubic_algorithm = 500;

// The smallest corner comes first: equal for equal triangles that look the same way.
inline Triangle from_smallest(Triangle triangle)
{
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

// The triangle that looks the other way.
inline Triangle turned_over(const Triangle& triangle)
{
  return from_smallest({triangle[0], triangle[2], triangle[1]});
}

inline std::set<Edge> edges_of(const std::vector<Triangle>& triangles)
{
  std::set<Edge> edges;
  for (const Triangle& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges.insert(std::minmax(triangle[i], triangle[(i + 1) % 3]));
  return edges;
}

// Makes caps of loops, the same for a loop whatever its first vertex and its direction are.
class Capper
{
public:
  explicit Capper(const Mesh_to_close& mesh) : m_mesh(mesh)
  {
    for (const auto v : vertices(mesh))
      m_points.push_back(mesh.point(v));
  }

  // Of the vertices of the mesh and, behind them, those that caps added.
  const std::vector<Mesh_to_close::Point>& points() const { return m_points; }

  // Triangles with all edges of the loop in its direction.
  std::vector<Triangle> cap(Loop loop)
  {
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    const bool is_turned = loop.back() < loop[1];
    if (is_turned)
      std::reverse(loop.begin() + 1, loop.end());
    const auto [known, is_new] = m_caps.emplace(loop, std::vector<Triangle>());
    if (is_new)
      known->second = make_cap(loop);
    std::vector<Triangle> triangles = known->second;
    if (is_turned)
      std::transform(triangles.begin(), triangles.end(), triangles.begin(), turned_over);
    return triangles;
  }

  // Is there an edge of the mesh or inside of a cap?
  bool is_edge(const Edge& edge) const
  {
    return m_diagonals.count(edge) > 0 ||
           halfedge(Mesh_to_close::Vertex_index(Mesh_to_close::size_type(edge.first)),
                    Mesh_to_close::Vertex_index(Mesh_to_close::size_type(edge.second)), m_mesh)
             .second;
  }

private:
  // A diagonal that is an edge already would have more than two faces.
  std::vector<Triangle> make_cap(const Loop& loop)
  {
    std::vector<Triangle> triangles = triangulate(loop);
    std::set<Edge> diagonals = edges_of(triangles);
    for (std::size_t i = 0; i < loop.size(); ++i)
      diagonals.erase(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
    const bool is_usable = triangles.size() + 2 == loop.size() &&
                           std::none_of(diagonals.begin(), diagonals.end(),
                                        [this](const Edge& edge) { return is_edge(edge); });
    if (!is_usable)
      return fan(loop);
    m_diagonals.insert(diagonals.begin(), diagonals.end());
    return triangles;
  }

  std::vector<Triangle> triangulate(const Loop& loop) const
  {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Mesh_to_close::Point> corners;
    for (const std::size_t v : loop)
      corners.push_back(m_points[v]);
    scale_to_unit(corners); // CGAL compares squares of areas
    std::vector<Kernel::Point_3> points;
    for (const Mesh_to_close::Point& p : corners)
      points.emplace_back(p.x(), p.y(), p.z());
    std::vector<CGAL::Triple<int, int, int>> found;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      points, std::back_inserter(found),
      CGAL::parameters::do_not_use_cubic_algorithm(loop.size() > longest_loop_for_cubic_algorithm));
    std::vector<Triangle> triangles;
    for (const auto& [a, b, c] : found)
    {
      std::array<int, 3> sorted = {a, b, c};
      std::sort(sorted.begin(), sorted.end()); // in the direction of the loop
      triangles.push_back(from_smallest(
        {loop[std::size_t(sorted[0])], loop[std::size_t(sorted[1])], loop[std::size_t(sorted[2])]}));
    }
    return triangles;
  }

  // Around a vertex of its own, in the middle.
  std::vector<Triangle> fan(const Loop& loop)
  {
    const double share = 1. / static_cast<double>(loop.size());
    Simple_cartesian<double>::Vector_3 sum(0, 0, 0);
    for (const std::size_t v : loop)
      sum = sum + share * (m_points[v] - CGAL::ORIGIN);
    const std::size_t centre = m_points.size();
    m_points.push_back(CGAL::ORIGIN + sum);
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < loop.size(); ++i)
      triangles.push_back(from_smallest({loop[i], loop[(i + 1) % loop.size()], centre}));
    return triangles;
  }

  const Mesh_to_close& m_mesh;
  std::vector<Mesh_to_close::Point> m_points;
  std::map<Loop, std::vector<Triangle>> m_caps;
  std::set<Edge> m_diagonals; // of all caps
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CLOSING_CAPPER_H
