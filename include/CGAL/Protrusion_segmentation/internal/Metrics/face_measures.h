// SPDX-License-Identifier: GPL-3.0-or-later
//
// Areas of the faces of a polygon mesh and its average radius, in double.

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_FACE_MEASURES_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_FACE_MEASURES_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

using Double_kernel = CGAL::Simple_cartesian<double>;

template <typename Point>
Double_kernel::Point_3 to_double_point(const Point& point)
{
  return Double_kernel::Point_3(CGAL::to_double(point.x()), CGAL::to_double(point.y()),
                                CGAL::to_double(point.z()));
}

struct Area_and_centroid
{
  double area = 0;
  Double_kernel::Point_3 centroid = CGAL::ORIGIN;
};

// Stands in for the centroid of a polygon without area.
inline Double_kernel::Point_3 corner_average(const std::vector<Double_kernel::Point_3>& corners)
{
  Double_kernel::Vector_3 sum(0, 0, 0);
  for(const Double_kernel::Point_3& corner : corners)
    sum = sum + (corner - corners.front());
  return corners.front() + sum / double(corners.size());
}

// Half the length of the area vector, which is the area of a plane polygon, convex or not, and that
// of the projection along the mean normal otherwise. The centroid is the one of the fan of signed
// triangles around the first corner: that of a plane polygon.
inline Area_and_centroid area_and_centroid(const std::vector<Double_kernel::Point_3>& corners)
{
  Double_kernel::Vector_3 twice_area(0, 0, 0);
  for(std::size_t i = 2; i < corners.size(); ++i)
    twice_area = twice_area + CGAL::cross_product(corners[i - 1] - corners[0],
                                                  corners[i] - corners[0]);
  const double length = std::sqrt(twice_area.squared_length());
  if(!(length > 0))
    return {0, corner_average(corners)};

  Double_kernel::Vector_3 moment(0, 0, 0);
  for(std::size_t i = 2; i < corners.size(); ++i)
  {
    const Double_kernel::Vector_3 u = corners[i - 1] - corners[0];
    const Double_kernel::Vector_3 v = corners[i] - corners[0];
    const double weight = CGAL::cross_product(u, v) * twice_area / (length * length);
    moment = moment + (u + v) * (weight / 3);
  }
  return {length / 2, corners[0] + moment};
}

// The map of the named parameter `vertex_point_map`, or the mesh's own.
template <typename FaceGraph, typename NamedParameters>
auto vertex_point_map(const FaceGraph& mesh, const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(CGAL::vertex_point, mesh));
}

// One entry a face, in the order of `faces(mesh)`.
template <typename FaceGraph, typename VertexPointMap>
std::vector<Area_and_centroid> face_areas_and_centroids(const FaceGraph& mesh,
                                                        const VertexPointMap& vertex_points)
{
  std::vector<Area_and_centroid> result;
  result.reserve(num_faces(mesh));
  std::vector<Double_kernel::Point_3> corners;
  for(const auto f : faces(mesh))
  {
    corners.clear();
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.push_back(to_double_point(get(vertex_points, v)));
    result.push_back(area_and_centroid(corners));
  }
  return result;
}

template <typename FaceGraph, typename VertexPointMap>
std::vector<double> face_areas(const FaceGraph& mesh, const VertexPointMap& vertex_points)
{
  std::vector<double> areas;
  areas.reserve(num_faces(mesh));
  for(const Area_and_centroid& face : face_areas_and_centroids(mesh, vertex_points))
    areas.push_back(face.area);
  return areas;
}

// Mean distance of the face centroids from their mean, both weighted by area; 0 without area.
inline double average_radius(const std::vector<Area_and_centroid>& faces)
{
  double area = 0;
  Double_kernel::Vector_3 moment(0, 0, 0);
  for(const Area_and_centroid& face : faces)
  {
    area += face.area;
    moment = moment + face.area * (face.centroid - faces.front().centroid);
  }
  if(!(area > 0))
    return 0;

  const Double_kernel::Point_3 center = faces.front().centroid + moment / area;
  double sum = 0;
  for(const Area_and_centroid& face : faces)
    sum += face.area * std::sqrt(CGAL::squared_distance(face.centroid, center));
  return sum / area;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_METRICS_FACE_MEASURES_H
