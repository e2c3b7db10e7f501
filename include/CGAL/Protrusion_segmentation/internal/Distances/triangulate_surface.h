// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_TRIANGULATE_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_TRIANGULATE_SURFACE_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/opposite_corner.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A surface as a halfedge structure of triangles, for algorithms that need one. Every polygon is the fan of
// triangles around its first corner; the triangles are in the order of the faces.
template <typename Point>
struct Triangulated_surface
{
  Surface_mesh<Point> mesh;
  std::vector<Indexed_surface::Index> first_triangle; // of every face, and the end
};

// Builds the halfedges from what faces are neighbours, not from what vertices they share: a surface that
// touches itself in a vertex or an edge, which cannot be built vertex by vertex, is cut there, as it is in
// the dual graph. Edges beyond which the orientation changes become borders, and faces with fewer than
// three corners become nothing.
template <typename Point>
class Surface_triangulator
{
public:
  using Index = Indexed_surface::Index;
  using Mesh = Surface_mesh<Point>;
  using Halfedge = typename Mesh::Halfedge_index;

  explicit Surface_triangulator(const Indexed_surface& surface)
    : m_surface(surface), m_halfedges(surface.number_of_corners())
  {}

  Triangulated_surface<Point> operator()()
  {
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
    {
      m_result.first_triangle.push_back(static_cast<Index>(m_mesh.number_of_faces()));
      if (is_polygon(f))
        add_fan(f);
    }
    m_result.first_triangle.push_back(static_cast<Index>(m_mesh.number_of_faces()));
    for (const Halfedge h : m_mesh.halfedges())
      if (m_mesh.is_border(h))
        m_mesh.set_next(h, next_border(h));
    for (const Halfedge h : m_mesh.halfedges())
      if (!m_mesh.is_border(h) && !m_mesh.target(h).is_valid())
        add_vertex(h);
    return std::move(m_result);
  }

private:
  bool is_polygon(Index f) const { return m_surface.first_corner(f + 1) - m_surface.first_corner(f) >= 3; }

  // The same edge seen from the face beyond it, if that is oriented alike and is a polygon.
  Index opposite_corner_of_polygon(Index f, Index corner) const
  {
    const Index g = m_surface.neighbor(corner);
    return g != Indexed_surface::no_face() && is_polygon(g) ? opposite_corner(m_surface, f, corner) : Indexed_surface::no_face();
  }

  // The halfedge from a corner to the next one.
  Halfedge halfedge_of_corner(Index f, Index c)
  {
    const Index opposite = opposite_corner_of_polygon(f, c);
    const bool is_known = opposite != Indexed_surface::no_face() && m_halfedges[opposite].is_valid() &&
                          m_mesh.is_border(m_mesh.opposite(m_halfedges[opposite]));
    m_halfedges[c] = is_known ? m_mesh.opposite(m_halfedges[opposite]) : m_mesh.add_edge();
    return m_halfedges[c];
  }

  void add_fan(Index f)
  {
    const Index first = m_surface.first_corner(f), last = m_surface.first_corner(f + 1) - 1;
    Halfedge from_first = halfedge_of_corner(f, first);
    for (Index c = first + 1; c < last; ++c)
    {
      const Halfedge to_first = c + 1 == last ? Halfedge() : m_mesh.add_edge();
      const Halfedge side = halfedge_of_corner(f, c);
      const Halfedge closing = to_first.is_valid() ? to_first : halfedge_of_corner(f, last);
      add_triangle({from_first, side, closing}, {c, c + 1, first});
      if (to_first.is_valid())
        from_first = m_mesh.opposite(to_first);
    }
  }

  void add_triangle(const std::array<Halfedge, 3>& halfedges, const std::array<Index, 3>& target_corners)
  {
    const typename Mesh::Face_index triangle = m_mesh.add_face();
    m_mesh.set_halfedge(triangle, halfedges[2]);
    m_target.resize(m_mesh.number_of_halfedges());
    for (std::size_t i = 0; i < 3; ++i)
    {
      m_mesh.set_face(halfedges[i], triangle);
      m_mesh.set_next(halfedges[i], halfedges[(i + 1) % 3]);
      m_target[halfedges[i]] = m_surface.vertex(target_corners[i]);
    }
  }

  // The border halfedge that begins where a given one ends: around that vertex to the other border.
  Halfedge next_border(Halfedge h) const
  {
    Halfedge next = m_mesh.opposite(h);
    while (!m_mesh.is_border(next))
      next = m_mesh.opposite(m_mesh.next(m_mesh.next(next)));
    return next;
  }

  // One vertex for all halfedges around the end of `h`; a border vertex has a border halfedge.
  void add_vertex(Halfedge h)
  {
    const Indexed_surface::Point_3& p = m_surface.point(m_target[h]);
    const typename Mesh::Vertex_index v = m_mesh.add_vertex(Point(p.x(), p.y(), p.z()));
    m_mesh.set_halfedge(v, h);
    Halfedge around = h;
    do
    {
      m_mesh.set_target(around, v);
      if (m_mesh.is_border(around))
        m_mesh.set_halfedge(v, around);
      around = m_mesh.opposite(m_mesh.next(around));
    } while (around != h);
  }

  const Indexed_surface& m_surface;
  Triangulated_surface<Point> m_result;
  Mesh& m_mesh = m_result.mesh;
  std::vector<Halfedge> m_halfedges; // of the corners
  std::vector<Index> m_target;       // of the halfedges: the vertex of the surface at their end
};

// Moves the corners of triangles that are next to flat, by a thousandth of the triangle's longest edge, in
// pseudo-random directions: cotangents and unfolded triangles need an area. Distances change by less than the
// length of a face. Returns whether all triangles have an area then:
// they are not where all corners are one point, or coordinates are too large for such a move.
template <typename Point>
bool widen_flat_triangles(Surface_mesh<Point>& mesh)
{
  constexpr double flat = 1e-5;   // height / longest edge; sine of the smallest angle, about
  constexpr double reach = 1e-3;
  const auto longest_and_height = [&mesh](typename Surface_mesh<Point>::Face_index f)
  {
    const auto h = mesh.halfedge(f);
    const Point& p = mesh.point(mesh.target(h));
    const Point& q = mesh.point(mesh.target(mesh.next(h)));
    const Point& r = mesh.point(mesh.target(mesh.next(mesh.next(h))));
    const double longest = std::sqrt((std::max)({squared_distance(p, q), squared_distance(q, r),
                                                 squared_distance(r, p)}));
    const double height = std::sqrt(cross_product(q - p, r - p).squared_length()) / longest;
    return std::make_pair(longest, height);
  };
  std::mt19937 random; // its numbers are fixed by the standard, those of distributions are not
  const auto offset = [&random]() { return static_cast<double>(random()) / 4294967296. - 0.5; };
  const auto is_flat = [&](typename Surface_mesh<Point>::Face_index f)
  {
    const auto [longest, height] = longest_and_height(f);
    return !(height > flat * longest);
  };
  for (const auto f : mesh.faces())
    if (is_flat(f))
    {
      const double length = reach * longest_and_height(f).first;
      for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
        mesh.point(v) = mesh.point(v) + length * typename Kernel_traits<Point>::Kernel::Vector_3(
                                                   offset(), offset(), offset());
    }
  return std::none_of(mesh.faces().begin(), mesh.faces().end(), is_flat);
}

// What CGAL's distances over the faces work on; none where they cannot, for want of area.
template <typename Point>
std::unique_ptr<Triangulated_surface<Point>> triangulate_for_paths(const Indexed_surface& surface)
{
  auto result =
    std::make_unique<Triangulated_surface<Point>>(Surface_triangulator<Point>(surface)());
  return surface.area() > 0 && widen_flat_triangles(result->mesh) ? std::move(result) : nullptr;
}

// A property map of a mesh that calls `Execution::check()` now and then: for algorithms of CGAL that compute for seconds and
// have no visitor.
template <typename Map>
class Checking_map
{
public:
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = typename boost::property_traits<Map>::value_type;
  using reference = typename boost::property_traits<Map>::reference;
  using category = boost::readable_property_map_tag;

  Checking_map(Map map, Execution& execution) : m_map(map), m_execution(&execution) {}

  friend reference get(const Checking_map& map, const key_type& key)
  {
    constexpr std::size_t values_between_checks = 1 << 13;
    if (++map.m_number_of_values % values_between_checks == 0)
      map.m_execution->check();
    return get(map.m_map, key);
  }

private:
  Map m_map;
  Execution* m_execution;
  mutable std::size_t m_number_of_values = 0;
};

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_TRIANGULATE_SURFACE_H
