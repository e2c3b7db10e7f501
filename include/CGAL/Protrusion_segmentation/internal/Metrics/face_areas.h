// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Areas of the faces of a polygon mesh and its average radius, in double. All metrics are ratios, so that lengths and
// areas are in a unit in which they can be squared.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_FACE_AREAS_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_FACE_AREAS_H

#include <CGAL/Protrusion_segmentation/internal/Surface/normalize_points.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>
#include <CGAL/Protrusion_segmentation/internal/user_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

using Double_kernel = CGAL::Simple_cartesian<double>;

// The points of a mesh, in a unit in which squares of areas neither overflow nor vanish: a power of two, which changes no
// digit. Vertices without a face do not count: a far one would make the rest of the mesh tiny.
template <typename VertexPointMap>
class Scaled_points
{
public:
  // Throws if a coordinate is not finite.
  template <typename FaceGraph>
  Scaled_points(const FaceGraph& mesh, const VertexPointMap& vertex_points) : m_points(vertex_points)
  {
    Largest_coordinate largest;
    for (const auto f : faces(mesh))
      for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      {
        const Double_kernel::Point_3 point = to_double_point(get(m_points, v));
        if (!is_finite(point))
          throw_not_finite(mesh, v);
        largest.add(point);
      }
    m_exponent = largest.exponent();
  }

  template <typename Vertex>
  Double_kernel::Point_3 operator()(Vertex v) const
  {
    return scaled_by_power_of_two(to_double_point(get(m_points, v)), -m_exponent);
  }

private:
  template <typename FaceGraph, typename Vertex>
  [[noreturn]] static void throw_not_finite(const FaceGraph& mesh, Vertex v)
  {
    std::size_t position = 0;
    for (const auto other : vertices(mesh))
    {
      if (other == v)
        break;
      ++position;
    }
    throw std::invalid_argument("pmesh: vertex " + std::to_string(position) + " has a coordinate that is not finite");
  }

  VertexPointMap m_points;
  int m_exponent;
};

// In the unit of `Scaled_points`, one entry a face, in the order of `faces(mesh)`.
template <typename FaceGraph, typename VertexPointMap>
std::vector<Polygon_measures> face_areas_and_centroids(const FaceGraph& mesh,
                                                       const VertexPointMap& vertex_points)
{
  const Scaled_points points(mesh, vertex_points);
  std::vector<Polygon_measures> result;
  result.reserve(num_faces(mesh));
  std::vector<Double_kernel::Point_3> corners;
  for (const auto f : faces(mesh))
  {
    corners.clear();
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.push_back(points(v));
    result.push_back(measure_polygon(corners));
  }
  return result;
}

// The same without the centroids.
template <typename FaceGraph, typename VertexPointMap>
std::vector<double> face_areas(const FaceGraph& mesh, const VertexPointMap& vertex_points)
{
  std::vector<double> areas;
  areas.reserve(num_faces(mesh));
  for (const Polygon_measures& face : face_areas_and_centroids(mesh, vertex_points))
    areas.push_back(face.area);
  return areas;
}

// Mean distance of the face centroids from their mean, both weighted by area; 0 without area.
inline double average_radius(const std::vector<Polygon_measures>& faces)
{
  double area = 0;
  Double_kernel::Vector_3 moment(0, 0, 0);
  for (const Polygon_measures& face : faces)
  {
    area += face.area;
    moment = moment + face.area * (face.centroid - faces.front().centroid);
  }
  if (!(area > 0))
    return 0;

  const Double_kernel::Point_3 center = faces.front().centroid + moment / area;
  double sum = 0;
  for (const Polygon_measures& face : faces)
    sum += face.area * std::sqrt(CGAL::squared_distance(face.centroid, center));
  return sum / area;
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_FACE_AREAS_H
