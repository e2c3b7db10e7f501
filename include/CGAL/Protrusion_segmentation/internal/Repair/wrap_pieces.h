// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces around loose pieces that are near to each other.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_WRAP_PIECES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_WRAP_PIECES_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Radial_order.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/manifold_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/near_pieces.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Solid.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// A surface around pieces. Its points are its own.
struct Wrapped_pieces
{
  std::vector<Polygon_soup::Point_3> points;
  Manifold_surface surface; // `face_of_polygon` and `polygon_of_face` are the nearest ones
  std::vector<std::size_t> piece_of_polygon;
  std::vector<double> area_of_polygon;
};

inline Surface_arrays arrays_of(const std::vector<Polygon_soup::Point_3>& points,
                                const Polygons& polygons)
{
  Surface_arrays arrays;
  arrays.points = points;
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    for (const std::size_t corner : polygons[i])
      arrays.corner_vertices.push_back(static_cast<Surface_arrays::Index>(corner));
    arrays.corner_begin.push_back(static_cast<Surface_arrays::Index>(arrays.corner_vertices.size()));
  }
  return arrays;
}

// Wraps shapes one by one, in a soup of unit size. Surfaces may overlap where shapes are near to each other.
class Shape_wrapper
{
public:
  // The arguments must outlive the object.
  Shape_wrapper(const Polygon_soup& soup, Wrapped_pieces& result)
    : m_soup(soup),
      m_arrays(arrays_of(soup.points, soup.polygons)),
      m_result(result)
  {
    result.surface.face_of_polygon.resize(soup.polygons.size(), 0);
  }

  // Makes one of what is nearer than the width. What lies inside a shape before gets no surface.
  void add(const std::vector<std::size_t>& polygons, double width)
  {
    std::vector<std::array<std::size_t, 3>> triangles;
    for (const std::size_t i : polygons)
      for_each_triangle(m_soup, i,
                        [&](std::size_t a, std::size_t b, std::size_t c) {
                          triangles.push_back({a, b, c});
                        });
    const Shape* shape = shape_around(polygons);
    if (!shape && triangles.empty())
      shape = m_shapes.empty() ? nullptr : &m_shapes.front();
    else if (!shape)
      shape = &wrap(polygons, std::move(triangles), width);
    if (!shape)
      throw std::invalid_argument("polygons: none has an area");
    for (const std::size_t i : polygons)
      if (!m_soup.polygons[i].empty())
        m_result.surface.face_of_polygon[i] = shape->first_face + shape->nearest(centroid_of_face(m_arrays, Index(i)));
  }

private:
  using Index = Surface_arrays::Index;

  struct Shape
  {
    Shape(const Surface_arrays& surface, std::size_t first)
      : first_face(first),
        nearest(surface, boost::irange(Index(0), Index(surface.number_of_faces()))),
        solid(surface, boost::irange(Index(0), Index(surface.number_of_faces()))),
        box(bbox_3(surface.points.begin(), surface.points.end()))
    {}
    bool has_inside(const std::vector<Polygon_soup::Point_3>& points) const
    {
      for (const Polygon_soup::Point_3& p : points)
        if (!do_overlap(box, p.bbox()))
          return false;
      const std::vector<Bounded_side> sides = solid.sides(points);
      return std::count(sides.begin(), sides.end(), ON_BOUNDED_SIDE) == std::ptrdiff_t(sides.size());
    }
    std::size_t first_face;
    Nearest_polygon nearest;
    Solid solid;
    Bbox_3 box;
  };

  const Shape* shape_around(const std::vector<std::size_t>& polygons) const
  {
    std::vector<Polygon_soup::Point_3> corners;
    for (const std::size_t i : polygons)
      for (const std::size_t corner : m_soup.polygons[i])
        corners.push_back(m_soup.points[corner]);
    const auto found = std::find_if(m_shapes.begin(), m_shapes.end(),
                                    [&](const Shape& shape) { return shape.has_inside(corners); });
    return found == m_shapes.end() ? nullptr : &*found;
  }

  const Shape& wrap(const std::vector<std::size_t>& polygons,
                    std::vector<std::array<std::size_t, 3>> triangles,
                    double width)
  {
    // A ball that fits into a gap of that width, between the surfaces at a distance from the polygons, can pass.
    constexpr double radius_to_width = 0.4, distance_to_width = 0.1;
    std::vector<Soup_kernel::Point_3> points; // of this shape alone
    std::unordered_map<std::size_t, std::size_t> numbers;
    for (std::array<std::size_t, 3>& triangle : triangles)
      for (std::size_t& corner : triangle)
      {
        const auto [number, is_new] = numbers.emplace(corner, points.size());
        if (is_new)
          points.push_back(exact(m_soup.points[corner]));
        corner = number->second;
      }
    Surface_mesh<Soup_kernel::Point_3> mesh;
    alpha_wrap_3(points, triangles, radius_to_width * width, distance_to_width * width, mesh);
    return add_surface(mesh, polygons);
  }

  const Shape& add_surface(const Surface_mesh<Soup_kernel::Point_3>& mesh,
                           const std::vector<std::size_t>& polygons)
  {
    const std::size_t first_point = m_result.points.size(), first_face = m_result.surface.faces.size();
    Surface_arrays surface;
    for (const auto v : mesh.vertices())
      surface.points.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    m_result.points.insert(m_result.points.end(), surface.points.begin(), surface.points.end());
    for (const auto f : mesh.faces())
    {
      std::vector<std::size_t> face;
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      {
        face.push_back(first_point + std::size_t(v));
        surface.corner_vertices.push_back(Index(v));
      }
      surface.corner_begin.push_back(static_cast<Index>(surface.corner_vertices.size()));
      m_result.surface.faces.add(face);
    }
    const Nearest_polygon nearest(m_arrays, polygons);
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      m_result.surface.polygon_of_face.push_back(nearest(centroid_of_face(surface, f)));
    return m_shapes.emplace_back(surface, first_face);
  }

  const Polygon_soup& m_soup;
  Surface_arrays m_arrays;
  Wrapped_pieces& m_result;
  std::deque<Shape> m_shapes;
};

inline double checked_gap(std::optional<double> gap, double size)
{
  constexpr double share_of_size = 0.025;
  if (!gap)
    return share_of_size * size;
  if (!(*gap > 0 && *gap <= size))
    throw std::invalid_argument("gap: " + std::to_string(*gap) +
                                " is not between 0 and the size of the mesh");
  return *gap;
}

inline double size_of(const std::vector<Polygon_soup::Point_3>& points)
{
  const Bbox_3 box = bbox_3(points.begin(), points.end());
  return std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
}

// The width of openings that are closed, so that a number of shapes of a size has not too many faces.
inline double least_width(double size, std::size_t number_of_shapes, double most_faces)
{
  // measured: of a surface around a creature or a machine whose openings are as wide as it is large, if it had the same
  // number of faces in each square of that width as with a fortieth
  constexpr double faces_of_size = 14;
  return size * std::sqrt(faces_of_size * double(number_of_shapes) / most_faces);
}

// Wraps the pieces of a soup of unit size. If the gap is so narrow that the surface would have too many faces, the pieces that
// are nearer than it are found by their distances, and the shapes that they make up are wrapped one by one.
inline void wrap_shapes(
  const Polygon_soup& soup, double size, double gap, double most_faces, Wrapped_pieces& result)
{
  std::vector<std::vector<std::size_t>> shapes(1);
  if (gap < least_width(size, 1, most_faces))
    shapes = shapes_of_pieces(soup, result.piece_of_polygon, gap);
  else
  {
    shapes.front().resize(soup.polygons.size());
    std::iota(shapes.front().begin(), shapes.front().end(), std::size_t(0));
  }
  // those that have an area first, and the largest of them: others may lie inside
  std::vector<std::tuple<bool, double, std::size_t>> order;
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    std::vector<Polygon_soup::Point_3> points;
    bool is_degenerate = true;
    for (const std::size_t i : shapes[s])
    {
      for (const std::size_t corner : soup.polygons[i])
        points.push_back(soup.points[corner]);
      for_each_triangle(soup, i, [&](std::size_t, std::size_t, std::size_t) { is_degenerate = false; });
    }
    order.emplace_back(is_degenerate, -size_of(points), s);
  }
  std::sort(order.begin(), order.end());
  Shape_wrapper wrapper(soup, result);
  for (const auto& [is_degenerate, negative_size, s] : order)
    wrapper.add(shapes[s], (std::max)(gap, least_width(-negative_size, shapes.size(), most_faces)));
}

// For each polygon a name of its component: closed solids that touch are components of their own.
inline std::vector<std::size_t> pieces_of_polygons(const Polygon_soup& soup)
{
  const Manifold_surface surface = manifold_surface(soup);
  std::vector<std::size_t> vertices(surface.point_of_vertex.size());
  std::iota(vertices.begin(), vertices.end(), std::size_t(0));
  const std::vector<std::size_t> components = clusters_of_polygons(surface.faces, vertices);
  std::vector<std::size_t> result;
  for (const std::size_t face : surface.face_of_polygon)
    result.push_back(components[face]);
  return result;
}

// Surfaces around all that is nearer to each other than the gap; an automatic one if none is given. They have about
// `most_faces` faces at most; the default takes a quarter of a minute.
inline Wrapped_pieces wrap_pieces(Polygon_soup soup, std::optional<double> gap, double most_faces = 150000)
{
  Wrapped_pieces result;
  result.piece_of_polygon = pieces_of_polygons(soup);
  const int exponent = scale_to_unit(soup);
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
    result.area_of_polygon.push_back(
      soup.polygons[i].empty() ? 0
                               : std::sqrt(area_vector(soup.points, soup.polygons[i]).squared_length()));
  const double size = size_of(of_corners(soup.points, soup.polygons.corners()));
  wrap_shapes(soup, size, std::ldexp(checked_gap(gap, std::ldexp(size, exponent)), -exponent), most_faces,
              result);

  Manifold_surface& surface = result.surface;
  surface.point_of_vertex.resize(result.points.size());
  std::iota(surface.point_of_vertex.begin(), surface.point_of_vertex.end(), std::size_t(0));
  const std::vector<std::size_t> components = clusters_of_polygons(surface.faces,
                                                                   surface.point_of_vertex);
  surface.repairs.components = std::set<std::size_t>(components.begin(), components.end()).size();
  for (Polygon_soup::Point_3& p : result.points)
    p = scaled_by_power_of_two(p, exponent);
  return result;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_WRAP_PIECES_H
