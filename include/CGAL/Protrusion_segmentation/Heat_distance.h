// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_HEAT_DISTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_HEAT_DISTANCE_H

#if !__has_include(<Eigen/Core>)
#error "Heat_distance.h needs the header library Eigen (Debian: libeigen3-dev)"
#endif
#if !defined(CGAL_EIGEN3_ENABLED)
#define CGAL_EIGEN3_ENABLED 1 // or else the solvers of CGAL hide those of Eigen
#endif

#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/largest_distance_sum.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/triangulate_surface.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationDistances

The distance of the heat method: a smooth approximation of the distance over the surface, which does not
zigzag over the faces as paths in the face dual graph do, computed by
`CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3`.

The source is the set of corners of a face; the distance of another face is the mean of the distances of its
corners. Polygons are divided into triangles, next to flat triangles are widened a little, and the surface is
cut where it touches itself in a vertex.

It is no metric, only near to one. The search for the face of eq. (1) relies on the triangle inequality and
so may find a face with a sum that is smaller than the largest one, by the error of the distances.

Preparing the distances on a part costs two sparse factorizations, about linear time in practice; the
distances from a face cost two solutions with them. Where the method gives no number, since the surface has no
area or the heat does not reach its far end, `Geodesic_distance` takes its place for this source.

The header needs the library Eigen.

\cgalModels{ProtrusionDistance}
*/
class Heat_distance
{
public:
  /// the distances on one part
  /// \cgalModels{ProtrusionDistancesOnSurface}
  class On_surface
  {
  public:
    explicit On_surface(const Indexed_surface& part)
      : m_part(part),
        m_triangulated(std::make_unique<Triangulated>(internal::Surface_triangulator<Point>(part)())),
        m_shortest_distances(part)
    {
      if (part.area() > 0 && internal::widen_flat_triangles(m_triangulated->mesh))
        m_heat_method = std::make_unique<Heat_method>(m_triangulated->mesh);
    }

    /// computes the distances from a face.
    /// \param source the face
    /// \param distances is filled with the distances of all faces
    void operator()(Indexed_surface::Index source, std::vector<double>& distances)
    {
      ++m_number_of_runs;
      if (!heat_distances(source, distances))
        m_shortest_distances(source, distances);
    }
    /// \return the face of eq. (1), up to the error of the distances
    Indexed_surface::Index face_of_largest_sum() { return internal::largest_distance_sum(m_part, *this); }
    /// \return from how many faces distances were computed so far
    std::size_t number_of_runs() const { return m_number_of_runs; }

  private:
    using Point = Indexed_surface::Point_3;
    using Triangulated = internal::Triangulated_surface<Point>;
    using Mesh = Surface_mesh<Point>;
    using Heat_method =
      Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, Heat_method_3::Direct>;

    // Calls `visit` with the vertices of the triangles of a face.
    template <typename Visit>
    void visit_vertices(Indexed_surface::Index face, Visit visit) const
    {
      const Mesh& mesh = m_triangulated->mesh;
      for (auto t = m_triangulated->first_triangle[face]; t < m_triangulated->first_triangle[face + 1]; ++t)
        for (const Mesh::Vertex_index v :
             vertices_around_face(mesh.halfedge(Mesh::Face_index(t)), mesh))
          visit(v);
    }

    // Returns whether all distances are numbers.
    bool heat_distances(Indexed_surface::Index source, std::vector<double>& distances)
    {
      if (!m_heat_method)
        return false;
      m_heat_method->clear_sources();
      visit_vertices(source, [this](Mesh::Vertex_index v) { m_heat_method->add_source(v); });
      m_of_vertex.resize(m_triangulated->mesh.number_of_vertices());
      m_heat_method->estimate_geodesic_distances(
        boost::make_iterator_property_map(m_of_vertex.begin(), get(vertex_index, m_triangulated->mesh)));
      distances.assign(m_part.number_of_faces(), 0);
      for (Indexed_surface::Index f = 0; f < m_part.number_of_faces(); ++f)
      {
        std::size_t count = 0;
        visit_vertices(f, [&](Mesh::Vertex_index v)
                       { distances[f] += (m_of_vertex[v] - distances[f]) / static_cast<double>(++count); });
        // where the heat does not reach, the heat method's answer is not a number or the largest one
        if (count == 0 || !(distances[f] < (std::numeric_limits<double>::max)() / 2))
          return false;
      }
      return true;
    }

    const Indexed_surface& m_part;
    std::unique_ptr<Triangulated> m_triangulated; // where it is when an `On_surface` is moved
    std::unique_ptr<Heat_method> m_heat_method;   // refers to the mesh; none where it cannot work
    internal::Shortest_distances m_shortest_distances;
    std::vector<double> m_of_vertex;
    std::size_t m_number_of_runs = 0;
  };

  /// prepares the distances on a connected part.
  /// \param part the part, which must outlive the result
  /// \return the distances on it
  /// \throw CGAL::Failure_exception if a matrix cannot be factorized
  On_surface on(const Indexed_surface& part, unsigned int /* random_seed */) const { return On_surface(part); }
};

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_HEAT_DISTANCE_H
