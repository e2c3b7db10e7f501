// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_HEAT_DISTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_HEAT_DISTANCE_H

#if defined(CGAL_EIGEN3_ENABLED) || defined(DOXYGEN_RUNNING)

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/Shortest_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/triangulate_surface.h>
#include <CGAL/Protrusion_segmentation/internal/inline.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL::Protrusion_segmentation {

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

Preparing the distances on a surface costs two sparse factorizations, about linear time in practice; the
distances from a face cost two solutions with them. Where the method gives no number, since the surface has no
area or the heat does not reach its far end, `Geodesic_distance` takes its place for this source.

The header needs the library Eigen.

\cgalModels{ProtrusionDistance}
*/
class Heat_distance
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
    void operator()(Indexed_surface::Index source, std::vector<double>& distances)
    {
      ++m_number_of_runs;
      if (!heat_distances(source, distances))
        m_shortest_distances(source, distances);
    }
    /// \return the face of eq. (1), up to the error of the distances
    Indexed_surface::Index face_of_largest_sum();
    /// \return from how many faces distances were computed so far
    std::size_t number_of_runs() const { return m_number_of_runs; }

  private:
    using Point = Indexed_surface::Point_3;
    using Triangulated = internal::Triangulated_surface<Point>;
    using Mesh = Surface_mesh<Point>;
    // asked about by the heat method between its two factorizations
    using Point_map = internal::Checking_map<boost::property_map<Mesh, vertex_point_t>::const_type>;
    using Heat_method =
      Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, Heat_method_3::Direct, Point_map>;

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
    bool heat_distances(Indexed_surface::Index source, std::vector<double>& distances);

    const Indexed_surface& m_surface;
    Execution& m_execution;
    std::unique_ptr<Triangulated> m_triangulated; // stays where it is when an `On_surface` is moved
    std::unique_ptr<Heat_method> m_heat_method;   // refers to the mesh; none where it cannot work
    internal::Shortest_distances m_shortest_distances;
    std::vector<double> m_of_vertex;
    std::size_t m_number_of_runs = 0;
  };

  /// prepares the distances on a connected surface.
  /// \param surface the surface, which must outlive the result
  /// \param execution asked whether to go on, which must outlive the result
  /// \return the distances on it
  /// \throw CGAL::Failure_exception if a matrix cannot be factorized
  On_surface on(const Indexed_surface& surface, Execution& execution) const
  {
    return On_surface(surface, execution);
  }
};

} // namespace CGAL::Protrusion_segmentation

#if !defined(DOXYGEN_RUNNING) && !defined(CGAL_PROTRUSION_SEGMENTATION_COMPILED_DISTANCES)

#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>

namespace CGAL::Protrusion_segmentation {

CGAL_PROTRUSION_SEGMENTATION_INLINE
Heat_distance::On_surface::On_surface(const Indexed_surface& surface, Execution& execution)
  : m_surface(surface),
    m_execution(execution),
    m_triangulated(internal::triangulate_for_paths<Point>(surface)),
    m_shortest_distances(surface)
{
  execution.check();
  if (m_triangulated)
    m_heat_method = std::make_unique<Heat_method>(
      m_triangulated->mesh, Point_map(get(vertex_point, m_triangulated->mesh), execution));
}

CGAL_PROTRUSION_SEGMENTATION_INLINE Indexed_surface::Index
Heat_distance::On_surface::face_of_largest_sum()
{
  return internal::largest_distance_sum(m_surface, *this, m_execution);
}

CGAL_PROTRUSION_SEGMENTATION_INLINE bool
Heat_distance::On_surface::heat_distances(Indexed_surface::Index source, std::vector<double>& distances)
{
  if (!m_heat_method)
    return false;
  m_heat_method->clear_sources();
  visit_vertices(source, [this](Mesh::Vertex_index v) { m_heat_method->add_source(v); });
  m_of_vertex.resize(m_triangulated->mesh.number_of_vertices());
  m_heat_method->estimate_geodesic_distances(
    boost::make_iterator_property_map(m_of_vertex.begin(), get(vertex_index, m_triangulated->mesh)));
  distances.assign(m_surface.number_of_faces(), 0);
  for (Indexed_surface::Index f = 0; f < m_surface.number_of_faces(); ++f)
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

} // namespace CGAL::Protrusion_segmentation

#endif

#else // without Eigen, the header compiles, and its use says what is missing

#include <CGAL/Default.h>

#include <type_traits>

namespace CGAL::Protrusion_segmentation {

template <typename Eigen = Default>
class Heat_distance
{
public:
  template <typename... Arguments>
  explicit Heat_distance(const Arguments&...)
  {
    static_assert(!std::is_same<Eigen, Default>::value,
                  "Heat_distance needs CGAL with Eigen: link with CGAL::Eigen3_support, or request the component "
                  "Eigen of Protrusion_segmentation");
  }
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_PROTRUSION_SEGMENTATION_HEAT_DISTANCE_H
