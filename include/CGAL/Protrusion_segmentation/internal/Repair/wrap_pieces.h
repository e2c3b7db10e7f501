// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One surface around loose pieces, and labels of the pieces from labels of that surface.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_WRAP_PIECES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_REPAIR_WRAP_PIECES_H

#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Radial_order.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/manifold_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/Surface_arrays.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/nested_components.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
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

// For each polygon of the first surface the nearest one of the second.
inline std::vector<std::size_t> nearest_polygons(const Surface_arrays& from, const Surface_arrays& to)
{
  std::vector<Surface_arrays::Index> all(to.number_of_faces());
  std::iota(all.begin(), all.end(), Surface_arrays::Index(0));
  const Solid solid(to, all);
  std::vector<std::size_t> result;
  for (Surface_arrays::Index f = 0; f < from.number_of_faces(); ++f)
  {
    const Corners_of_face<Surface_arrays> corners = {from, f};
    result.push_back(corners.size() == 0 ? 0 : solid.nearest_face(measure_polygon(corners).centroid));
  }
  return result;
}

// Wraps the polygons of a soup of unit size, so that what is nearer than the gap becomes one.
inline void wrap(const Polygon_soup& soup, double gap, Wrapped_pieces& result)
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  // A ball that fits into a gap of that width, between the surfaces at a distance from the polygons, can pass.
  constexpr double radius_to_gap = 0.4, distance_to_gap = 0.1;
  std::vector<Kernel::Point_3> points;
  for (const Polygon_soup::Point_3& p : soup.points)
    points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
    for (std::size_t c = 2; c < soup.polygons[i].size(); ++c)
    {
      const auto corner = soup.polygons[i].begin();
      const std::array<std::size_t, 3> triangle = {corner[0], corner[std::ptrdiff_t(c) - 1],
                                                   corner[std::ptrdiff_t(c)]};
      if (!collinear(points[triangle[0]], points[triangle[1]], points[triangle[2]]))
        triangles.push_back(triangle);
    }
  if (triangles.empty())
    throw std::invalid_argument("polygons: none has an area");
  Surface_mesh<Kernel::Point_3> mesh;
  alpha_wrap_3(points, triangles, radius_to_gap * gap, distance_to_gap * gap, mesh);
  for (const auto v : mesh.vertices())
    result.points.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  for (const auto f : mesh.faces())
  {
    std::vector<std::size_t> face;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      face.push_back(std::size_t(v));
    result.surface.faces.add(face);
  }
}

inline double checked_gap(std::optional<double> gap, double size)
{
  constexpr double share_of_size = 0.025, least_share = 1e-3; // with less there are millions of faces
  if (!gap)
    return share_of_size * size;
  if (!(*gap >= least_share * size && *gap <= size))
    throw std::invalid_argument("gap: " + std::to_string(*gap) +
                                " is not between a thousandth of the size of the mesh and all of it");
  return *gap;
}

// One surface around all that is nearer to each other than the gap; an automatic one if none is given.
inline Wrapped_pieces wrap_pieces(Polygon_soup soup, std::optional<double> gap)
{
  Wrapped_pieces result;
  result.piece_of_polygon = clusters_of_polygons(soup.polygons, places(soup.points));
  const int exponent = scale_to_unit(soup);
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
    result.area_of_polygon.push_back(
      soup.polygons[i].empty() ? 0
                               : std::sqrt(area_vector(soup.points, soup.polygons[i]).squared_length()));
  Bbox_3 box;
  for (const Polygon_soup::Point_3& p : corners_of(soup))
    box += p.bbox();
  const double size = std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) +
                                CGAL::square(box.z_span()));
  wrap(soup, std::ldexp(checked_gap(gap, std::ldexp(size, exponent)), -exponent), result);

  Manifold_surface& surface = result.surface;
  const Surface_arrays from = arrays_of(soup.points, soup.polygons),
                       to = arrays_of(result.points, surface.faces);
  surface.face_of_polygon = nearest_polygons(from, to);
  surface.polygon_of_face = nearest_polygons(to, from);
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
