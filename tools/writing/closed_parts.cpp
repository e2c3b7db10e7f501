// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/closed_parts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace tool
{
namespace
{

using Halfedge = Mesh::Halfedge_index;
using Loop = std::vector<std::size_t>;         // numbers of vertices
using Triangle = std::array<std::size_t, 3>;   // the same
using Edge = std::pair<std::size_t, std::size_t>;

Edge edge_between(std::size_t a, std::size_t b)
{
  return {(std::min)(a, b), (std::max)(a, b)};
}

// The smallest corner comes first: equal for equal triangles that look the same way.
Triangle from_smallest(Triangle triangle)
{
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

Triangle turned_over(const Triangle& triangle)
{
  return from_smallest({triangle[0], triangle[2], triangle[1]});
}

// Makes caps of loops, the same for a loop whatever its first vertex and its direction are.
class Capper
{
public:
  explicit Capper(const Mesh& mesh) : m_mesh(mesh)
  {
    for (const auto v : vertices(mesh))
      m_points.push_back(mesh.point(v));
  }

  // With the vertices of the mesh and those that caps added.
  const std::vector<Point>& points() const { return m_points; }

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

private:
  // For longer loops the search among all triangulations, in cubic time, takes longer than a second.
  static constexpr std::size_t longest_loop_for_cubic_algorithm = 500;

  // A diagonal that is an edge already would have more than two faces.
  std::vector<Triangle> make_cap(const Loop& loop)
  {
    std::vector<Triangle> triangles = triangulate(loop);
    std::set<Edge> diagonals;
    for (const Triangle& triangle : triangles)
      for (int i = 0; i < 3; ++i)
        diagonals.insert(edge_between(triangle[i], triangle[(i + 1) % 3]));
    for (std::size_t i = 0; i < loop.size(); ++i)
      diagonals.erase(edge_between(loop[i], loop[(i + 1) % loop.size()]));
    const bool is_usable = triangles.size() + 2 == loop.size() &&
                           std::none_of(diagonals.begin(), diagonals.end(),
                                        [this](const Edge& edge) { return is_edge(edge); });
    if (!is_usable)
      return fan(loop);
    m_diagonals.insert(diagonals.begin(), diagonals.end());
    return triangles;
  }

  bool is_edge(const Edge& edge) const
  {
    return m_diagonals.count(edge) > 0 ||
           halfedge(Mesh::Vertex_index(Mesh::size_type(edge.first)),
                    Mesh::Vertex_index(Mesh::size_type(edge.second)), m_mesh)
             .second;
  }

  std::vector<Triangle> triangulate(const Loop& loop) const
  {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_3> points;
    for (const std::size_t v : loop)
      points.emplace_back(m_points[v].x(), m_points[v].y(), m_points[v].z());
    std::vector<CGAL::Triple<int, int, int>> found;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      points, std::back_inserter(found),
      CGAL::parameters::do_not_use_cubic_algorithm(loop.size() > longest_loop_for_cubic_algorithm));
    std::vector<Triangle> triangles;
    for (const auto& [a, b, c] : found)
    {
      std::array<int, 3> corners = {a, b, c};
      std::sort(corners.begin(), corners.end()); // in the direction of the loop
      triangles.push_back(
        from_smallest({loop[std::size_t(corners[0])], loop[std::size_t(corners[1])], loop[std::size_t(corners[2])]}));
    }
    return triangles;
  }

  // Around a vertex of its own, in the middle.
  std::vector<Triangle> fan(const Loop& loop)
  {
    const double share = 1. / static_cast<double>(loop.size());
    Point::R::Vector_3 sum(0, 0, 0);
    for (const std::size_t v : loop)
      sum = sum + share * (m_points[v] - CGAL::ORIGIN);
    const std::size_t centre = m_points.size();
    m_points.push_back(CGAL::ORIGIN + sum);
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < loop.size(); ++i)
      triangles.push_back(from_smallest({loop[i], loop[(i + 1) % loop.size()], centre}));
    return triangles;
  }

  const Mesh& m_mesh;
  std::vector<Point> m_points;
  std::map<Loop, std::vector<Triangle>> m_caps;
  std::set<Edge> m_diagonals; // of all caps
};

// The loops of a walk that comes back to some of its vertices, none twice in one of them.
void add_simple_loops(const Loop& walk, std::vector<Loop>& loops)
{
  Loop open;
  std::map<std::size_t, std::size_t> place; // of the vertices of `open`
  for (const std::size_t v : walk)
  {
    if (const auto seen = place.find(v); seen != place.end())
    {
      const auto begin = open.begin() + std::ptrdiff_t(seen->second);
      loops.emplace_back(begin, open.end());
      for (auto w = begin + 1; w != open.end(); ++w)
        place.erase(*w);
      open.erase(begin + 1, open.end());
    }
    else
    {
      place[v] = open.size();
      open.push_back(v);
    }
  }
  loops.push_back(open);
}

// The borders of sets of segments.
class Borders
{
public:
  Borders(const Mesh& mesh, const std::vector<std::size_t>& segment_of_face)
    : m_mesh(mesh), m_segment_of_face(segment_of_face)
  {
    for (const Halfedge h : halfedges(mesh))
      if (!mesh.is_border(h) && !mesh.is_border(mesh.opposite(h)) && segment(h) != segment(mesh.opposite(h)))
        m_halfedges.push_back(h);
  }

  // The closed loops around the segments that are `inside`, with them on the left.
  std::vector<Loop> loops_around(const std::vector<bool>& inside) const
  {
    std::vector<Loop> loops;
    std::set<Halfedge> seen;
    for (const Halfedge h : m_halfedges)
      if (is_border(h, inside) && seen.count(h) == 0)
        if (const Loop walk = walk_from(h, inside, seen); !walk.empty())
          add_simple_loops(walk, loops);
    return loops;
  }

private:
  std::size_t segment(Halfedge h) const { return m_segment_of_face[m_mesh.face(h)]; }

  bool is_border(Halfedge h, const std::vector<bool>& inside) const
  {
    return inside[segment(h)] && !m_mesh.is_border(m_mesh.opposite(h)) && !inside[segment(m_mesh.opposite(h))];
  }

  // None if the walk ends at a border of the mesh.
  Loop walk_from(Halfedge first, const std::vector<bool>& inside, std::set<Halfedge>& seen) const
  {
    Loop walk;
    Halfedge h = first;
    do
    {
      seen.insert(h);
      walk.push_back(std::size_t(m_mesh.source(h)));
      h = m_mesh.next(h);
      while (!is_border(h, inside))
      {
        h = m_mesh.opposite(h);
        if (m_mesh.is_border(h))
          return {};
        h = m_mesh.next(h);
      }
    } while (h != first);
    return walk;
  }

  const Mesh& m_mesh;
  const std::vector<std::size_t>& m_segment_of_face;
  std::vector<Halfedge> m_halfedges; // between two segments
};

// For each segment: does it stick out of `segment`, or is it that itself?
std::vector<bool> subtree(std::size_t segment, const std::vector<std::size_t>& parents)
{
  std::vector<bool> inside(parents.size(), false);
  for (std::size_t s = 0; s < parents.size(); ++s)
  {
    std::size_t ancestor = s;
    while (ancestor != segment && parents[ancestor] != ancestor)
      ancestor = parents[ancestor];
    inside[s] = ancestor == segment;
  }
  return inside;
}

// Triangles without those that are there both ways.
class Caps_of_part
{
public:
  void add(const Triangle& triangle)
  {
    const auto other = m_triangles.find(turned_over(triangle));
    if (other != m_triangles.end())
      m_triangles.erase(other);
    else
      m_triangles.insert(triangle);
  }
  const std::multiset<Triangle>& triangles() const { return m_triangles; }

private:
  std::multiset<Triangle> m_triangles;
};

// Its points are only those that it needs.
class Part_builder
{
public:
  explicit Part_builder(const std::vector<Point>& points) : m_points(points) {}

  template <typename Corners>
  void add(const Corners& corners)
  {
    m_part.polygons.emplace_back();
    for (const std::size_t corner : corners)
    {
      const auto [position, is_new] = m_numbers.emplace(corner, m_part.points.size());
      if (is_new)
        m_part.points.push_back(m_points[corner]);
      m_part.polygons.back().push_back(position->second);
    }
  }
  Polygon_soup take() { return std::move(m_part); }

private:
  const std::vector<Point>& m_points;
  std::map<std::size_t, std::size_t> m_numbers;
  Polygon_soup m_part;
};

} // namespace

std::vector<Polygon_soup> closed_parts(const Mesh& mesh,
                                      const std::vector<std::size_t>& segment_of_face,
                                      const std::vector<std::size_t>& parents)
{
  Capper capper(mesh);
  const Borders borders(mesh, segment_of_face);
  std::vector<Caps_of_part> caps(parents.size());
  for (std::size_t s = 0; s < parents.size(); ++s)
    if (parents[s] != s)
      for (const Loop& loop : borders.loops_around(subtree(s, parents)))
        for (const Triangle& triangle : capper.cap(loop))
        {
          caps[s].add(turned_over(triangle)); // its edges meet those of the faces of the segment
          caps[parents[s]].add(triangle);
        }

  std::vector<Part_builder> builders(parents.size(), Part_builder(capper.points()));
  for (const Face f : faces(mesh))
  {
    Loop corners;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      corners.push_back(std::size_t(v));
    builders[segment_of_face[f]].add(corners);
  }
  std::vector<Polygon_soup> parts;
  for (std::size_t s = 0; s < parents.size(); ++s)
  {
    for (const Triangle& triangle : caps[s].triangles())
      builders[s].add(triangle);
    parts.push_back(builders[s].take());
  }
  return parts;
}

} // namespace tool
