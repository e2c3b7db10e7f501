// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_EXACT_GEODESIC_DISTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_EXACT_GEODESIC_DISTANCE_H

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/triangulate_surface.h>
#include <CGAL/Protrusion_segmentation/internal/inline.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationDistances

The length of the shortest path on the surface itself between the centroids of two faces, which may cross
faces anywhere, computed by `CGAL::Surface_mesh_shortest_path`. Exact up to rounding.

Polygons are divided into triangles, next to flat triangles are widened a little, and the surface is cut where
it touches itself in a vertex. Where the algorithm reaches a face on no path, its distance is that of
`Geodesic_distance`.

The distances from one face take time and memory quadratic in the number of faces at worst, in practice some
hundred times as long as shortest paths in the face dual graph: a reference for small meshes. Where a visitor stops a call,
the memory of the computation under way, which may be gigabytes, is freed first; that takes some 1.5 seconds for each gigabyte.

\cgalModels{ProtrusionDistance}
*/
class Exact_geodesic_distance
{
public:
  /// the distances on one surface
  /// \cgalModels{ProtrusionDistancesOnSurface}
  class On_surface
  {
  public:
    On_surface(const Indexed_surface& surface, Execution& execution);

    /// computes the distances from a face.
    /// \param source the face
    /// \param distances is filled with the distances of all faces
    void operator()(Indexed_surface::Index source, std::vector<double>& distances);
    /// \return the face of eq. (1), found exactly: the distance is a metric
    Indexed_surface::Index face_of_largest_sum();
    /// \return from how many faces distances were computed so far
    std::size_t number_of_runs() const { return m_number_of_runs; }

  private:
    static constexpr Indexed_surface::Index faces_between_questions = 64;

    using Kernel = Exact_predicates_inexact_constructions_kernel;
    using Point = Kernel::Point_3;
    using Triangulated = internal::Triangulated_surface<Point>;
    using Mesh = Surface_mesh<Point>;
    using Traits = Surface_mesh_shortest_path_traits<Kernel, Mesh>;

    template <typename Tag>
    using Mesh_map = internal::Checking_map<typename boost::property_map<Mesh, Tag>::const_type>;
    using Paths = Surface_mesh_shortest_path<Traits, Mesh_map<boost::vertex_index_t>, Mesh_map<boost::halfedge_index_t>,
                                             Mesh_map<boost::face_index_t>, Mesh_map<vertex_point_t>>;

    struct Location
    {
      Mesh::Face_index triangle;
      Traits::Barycentric_coordinates coordinates;
    };

    bool has_triangle(Indexed_surface::Index f) const
    {
      return m_triangulated->first_triangle[f] < m_triangulated->first_triangle[f + 1];
    }

    // The centroid of a face in the triangle of its fan that holds it, or holds it best where the fan
    // overlaps or misses it.
    Location locate_centroid(Indexed_surface::Index f) const;
    // Barycentric coordinates of the projection of a point, in the order of the corners that
    // `Surface_mesh_shortest_path` uses.
    std::array<double, 3> weights_in_triangle(Mesh::Face_index triangle,
                                              const Indexed_surface::Point_3& centroid) const;

    const Indexed_surface& m_surface;
    Execution& m_execution;
    std::unique_ptr<Triangulated> m_triangulated; // stays where it is when an `On_surface` is moved
    std::unique_ptr<Paths> m_paths;               // refers to the mesh; none where it cannot work
    std::vector<Location> m_centroids;
    internal::Shortest_distances m_shortest_distances;
    std::size_t m_number_of_runs = 0;
  };

  /// prepares the distances on a connected surface.
  /// \param surface the surface, which must outlive the result
  /// \param execution asked whether to go on, which must outlive the result
  /// \return the distances on it
  On_surface on(const Indexed_surface& surface, Execution& execution) const
  {
    return On_surface(surface, execution);
  }
};

} // namespace CGAL::Protrusion_segmentation

#if !defined(DOXYGEN_RUNNING) && !defined(CGAL_PROTRUSION_SEGMENTATION_COMPILED_DISTANCES)

#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Protrusion_segmentation {

CGAL_PROTRUSION_SEGMENTATION_INLINE
Exact_geodesic_distance::On_surface::On_surface(const Indexed_surface& surface, Execution& execution)
  : m_surface(surface),
    m_execution(execution),
    m_triangulated(internal::triangulate_for_paths<Point>(surface)),
    m_shortest_distances(surface)
{
  if (!m_triangulated)
    return;
  const Mesh& mesh = m_triangulated->mesh;
  const auto map = [&](auto tag) { return internal::Checking_map(get(tag, mesh), execution); };
  m_paths = std::make_unique<Paths>(mesh, map(boost::vertex_index), map(boost::halfedge_index),
                                    map(boost::face_index), map(vertex_point));
  for (Indexed_surface::Index f = 0; f < surface.number_of_faces(); ++f)
    m_centroids.push_back(locate_centroid(f));
}

CGAL_PROTRUSION_SEGMENTATION_INLINE void
Exact_geodesic_distance::On_surface::operator()(Indexed_surface::Index source, std::vector<double>& distances)
{
  ++m_number_of_runs;
  m_shortest_distances(source, distances);
  if (!m_paths || !has_triangle(source))
    return;
  m_execution.check();
  m_paths->remove_all_source_points();
  m_paths->add_source_point(m_centroids[source].triangle, m_centroids[source].coordinates);
  for (Indexed_surface::Index f = 0; f < m_surface.number_of_faces(); ++f)
    if (has_triangle(f))
    {
      if (f % faces_between_questions == 0)
        m_execution.check();
      const double distance =
        m_paths->shortest_distance_to_source_points(m_centroids[f].triangle, m_centroids[f].coordinates).first;
      if (distance >= 0 && std::isfinite(distance)) // -1: on no path
        distances[f] = distance;
    }
  distances[source] = 0;
}

CGAL_PROTRUSION_SEGMENTATION_INLINE Indexed_surface::Index
Exact_geodesic_distance::On_surface::face_of_largest_sum()
{
  return internal::largest_distance_sum(m_surface, *this, m_execution);
}

CGAL_PROTRUSION_SEGMENTATION_INLINE Exact_geodesic_distance::On_surface::Location
Exact_geodesic_distance::On_surface::locate_centroid(Indexed_surface::Index f) const
{
  Location best;
  double best_margin = -(std::numeric_limits<double>::infinity)();
  for (auto t = m_triangulated->first_triangle[f]; t < m_triangulated->first_triangle[f + 1]; ++t)
  {
    const Mesh::Face_index triangle(t);
    std::array<double, 3> weights =
      m_triangulated->first_triangle[f] + 1 == m_triangulated->first_triangle[f + 1]
        ? std::array<double, 3>{1, 1, 1}
        : weights_in_triangle(triangle, m_surface.centroid(f));
    const double margin = *std::min_element(weights.begin(), weights.end());
    if (margin <= best_margin)
      continue;
    best_margin = margin;
    for (double& w : weights)
      w = (std::max)(w, 0.);
    const double sum = weights[0] + weights[1] + weights[2];
    best = {triangle, {{weights[0] / sum, weights[1] / sum, weights[2] / sum}}};
  }
  return best;
}

CGAL_PROTRUSION_SEGMENTATION_INLINE std::array<double, 3>
Exact_geodesic_distance::On_surface::weights_in_triangle(Mesh::Face_index triangle,
                                                         const Indexed_surface::Point_3& centroid) const
{
  const Mesh& mesh = m_triangulated->mesh;
  const auto h = mesh.halfedge(triangle);
  const std::array<Point, 3> corners = {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                        mesh.point(mesh.target(mesh.next(h)))};
  const Point p(centroid.x(), centroid.y(), centroid.z());
  const Kernel::Vector_3 normal = cross_product(corners[1] - corners[0], corners[2] - corners[0]);
  std::array<double, 3> weights;
  for (std::size_t i = 0; i < 3; ++i)
    weights[i] = cross_product(corners[(i + 1) % 3] - p, corners[(i + 2) % 3] - p) * normal /
                 normal.squared_length();
  return weights;
}

} // namespace CGAL::Protrusion_segmentation

#endif

#endif // CGAL_PROTRUSION_SEGMENTATION_EXACT_GEODESIC_DISTANCE_H
