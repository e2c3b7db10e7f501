// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INDEXED_SURFACE_H
#define CGAL_PROTRUSION_SEGMENTATION_INDEXED_SURFACE_H

#include <CGAL/Protrusion_segmentation/internal/Execution/for_each_block.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/polygon_measures.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

A surface, or a piece of one, as index arrays. Distances and methods work on it.

The faces of a part are numbered from 0, so are its vertices and the corners of its faces: the corners
of face `f` are `first_corner(f)` to `first_corner(f + 1) - 1`, in the orientation of the mesh. The edge
of a corner leads from its vertex to the vertex of the next corner of the same face.

The face dual graph (Section III.B of the paper) has the faces as nodes and an arc in both directions
for every edge that two different faces share. The length of an arc is the distance between the
centroids of the two faces.

The coordinates are those of the input mesh, moved and scaled so that the whole surface fits into
\f$[-1, 1]^3\f$: neither tiny nor huge coordinates can under- or overflow. A connected surface is also rotated, and
mirrored where needed, so that the coordinates do not depend on the position of the mesh: the origin is its center of
gravity, the axes are those of inertia, and coordinates are rounded to multiples of \f$2^{-30}\f$.

The memory is about 50 bytes per triangle.
*/
class Indexed_surface
{
public:
  /// an index of a face, a vertex or a corner
  using Index = std::uint32_t;
  using Kernel = Simple_cartesian<double>;
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;

  /// what the dual graph stores for an arc
  struct Arc
  {
    double length;
  };

  /// a model of `boost::VertexListGraph` and `boost::IncidenceGraph`
  using Dual_graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Arc,
                                                        boost::no_property, Index, Index>;

  /// \return the number in the place of the face beyond a border edge
  static constexpr Index no_face() { return (std::numeric_limits<Index>::max)(); }

  Indexed_surface() = default;

  /// makes a surface from its arrays, in linear time.
  /// \param points the points of the vertices
  /// \param corner_begin the first corner of every face, ascending from 0, and the number of corners at the end. Every
  ///        face has at least one corner.
  /// \param corner_vertices the vertex of every corner
  /// \param corner_neighbors for each corner the face beyond its edge, or `no_face()`
  /// \throw std::invalid_argument if the arrays do not fit together, or if an index is too large
  Indexed_surface(std::vector<Point_3> points,
                  std::vector<Index> corner_begin,
                  std::vector<Index> corner_vertices,
                  std::vector<Index> corner_neighbors)
    : m_points(std::move(points)),
      m_corner_begin(std::move(corner_begin)),
      m_corner_vertices(std::move(corner_vertices)),
      m_corner_neighbors(std::move(corner_neighbors))
  {
    check_arrays();
    measure_faces(false);
  }

#ifndef DOXYGEN_RUNNING
  Indexed_surface(std::vector<Point_3> points,
                  std::vector<Index> corner_begin,
                  std::vector<Index> corner_vertices,
                  std::vector<Index> corner_neighbors,
                  bool is_parallel,
                  std::vector<Index> patches = {})
    : m_points(std::move(points)),
      m_corner_begin(std::move(corner_begin)),
      m_corner_vertices(std::move(corner_vertices)),
      m_corner_neighbors(std::move(corner_neighbors)),
      m_patches(std::move(patches))
  {
    measure_faces(is_parallel);
  }
#endif

  /// \return the number of faces
  Index number_of_faces() const { return static_cast<Index>(m_areas.size()); }
  /// \return the number of vertices
  Index number_of_vertices() const { return static_cast<Index>(m_points.size()); }
  /// \return the number of corners of all faces
  Index number_of_corners() const { return static_cast<Index>(m_corner_vertices.size()); }

  /// \return the point of a vertex
  /// \param vertex below `number_of_vertices()`
  const Point_3& point(Index vertex) const { return m_points[vertex]; }
  /// \return the first corner of a face
  /// \param face at most `number_of_faces()`, for which it is the number of corners
  Index first_corner(Index face) const { return m_corner_begin[face]; }
  /// \return the vertex of a corner
  /// \param corner below `number_of_corners()`
  Index vertex(Index corner) const { return m_corner_vertices[corner]; }
  /// \return the face beyond the edge of a corner, or `no_face()`
  /// \param corner below `number_of_corners()`
  Index neighbor(Index corner) const { return m_corner_neighbors[corner]; }
  /// \return the next corner of a face in its orientation
  /// \param face below `number_of_faces()`
  /// \param corner one of its corners
  Index next_corner(Index face, Index corner) const
  {
    return (corner + 1 == first_corner(face + 1)) ? first_corner(face) : corner + 1;
  }
  /// \return the length of the edge of a corner
  /// \param face below `number_of_faces()`
  /// \param corner one of its corners
  double edge_length(Index face, Index corner) const
  {
    return std::sqrt(squared_distance(point(vertex(corner)), point(vertex(next_corner(face, corner)))));
  }

  /// \return the center of gravity of a face, in constant time
  /// \param face below `number_of_faces()`
  Point_3 centroid(Index face) const
  {
    return m_centroids.empty() ? internal::triangle_centroid(Corners{*this, face}) : m_centroids[face];
  }
  /// \return the area of a face
  /// \param face below `number_of_faces()`
  double area(Index face) const { return m_areas[face]; }
  /// \return the sum of the areas of all faces
  double area() const { return m_area; }

  /// \return the length of an arc of the face dual graph: the distance between the centroids of two faces
  /// \param f below `number_of_faces()`
  /// \param g below `number_of_faces()`
  double arc_length(Index f, Index g) const
  {
    return std::sqrt(squared_distance(centroid(f), centroid(g)));
  }
  /// makes the face dual graph in linear time; it takes another 40 bytes per triangle.
  /// \return the graph, the arcs of a face in the order of its corners
  Dual_graph dual_graph() const
  {
    std::vector<Index> sources, targets;
    std::vector<Arc> arcs;
    sources.reserve(number_of_corners());
    targets.reserve(number_of_corners());
    arcs.reserve(number_of_corners());
    for (Index f = 0; f < number_of_faces(); ++f)
      for (Index c = first_corner(f); c < first_corner(f + 1); ++c)
        if (neighbor(c) != no_face())
        {
          sources.push_back(f);
          targets.push_back(neighbor(c));
          arcs.push_back({arc_length(f, neighbor(c))});
        }
    // sorted by source as they are, the vectors become those of the graph
    return Dual_graph(boost::construct_inplace_from_sources_and_targets, sources, targets, arcs,
                      number_of_faces());
  }

  /// \return a vector normal to a face, as long as its area: half the sum of the vector products of
  ///         consecutive corners
  /// \param face below `number_of_faces()`
  Vector_3 area_vector(Index face) const
  {
    return internal::polygon_area_vector(Corners{*this, face});
  }

#ifndef DOXYGEN_RUNNING
  // what `face_patch_map` says, unless it says the same of all faces
  bool has_patches() const { return !m_patches.empty(); }
  Index patch(Index face) const { return m_patches[face]; }

  bool has_triangles_only() const
  {
    for (std::size_t f = 0; f + 1 < m_corner_begin.size(); ++f)
      if (m_corner_begin[f + 1] - m_corner_begin[f] != 3)
        return false;
    return true;
  }
#endif

private:
  using Corners = internal::Corners_of_face<Indexed_surface>;

  void check_arrays() const
  {
    const std::vector<Index>& begin = m_corner_begin;
    if (begin.empty() || begin.front() != 0 || begin.back() != m_corner_vertices.size())
      throw std::invalid_argument("corner_begin: it does not begin with 0 and end with the number of corners");
    if (std::adjacent_find(begin.begin(), begin.end(), std::greater_equal<Index>()) != begin.end())
      throw std::invalid_argument("corner_begin: a face has no corner");
    if (m_corner_neighbors.size() != m_corner_vertices.size())
      throw std::invalid_argument("corner_neighbors: its size is not the number of corners");
    for (const Index v : m_corner_vertices)
      if (v >= m_points.size())
        throw std::invalid_argument("corner_vertices: there is no vertex " + std::to_string(v));
    for (const Index f : m_corner_neighbors)
      if (f != no_face() && f >= begin.size() - 1)
        throw std::invalid_argument("corner_neighbors: there is no face " + std::to_string(f));
  }

  void measure_face(Index f)
  {
    if (m_centroids.empty())
    {
      m_areas[f] = std::sqrt(area_vector(f).squared_length());
      return;
    }
    const internal::Polygon_measures face = internal::measure_polygon(Corners{*this, f});
    m_areas[f] = face.area;
    m_centroids[f] = face.centroid;
  }

  void measure_faces(bool is_parallel)
  {
    const std::size_t n = m_corner_begin.size() - 1;
    if (!has_triangles_only())
      m_centroids.resize(n);
    m_areas.resize(n);
    internal::for_each_number(n, is_parallel, [this](Index f) { measure_face(f); });
    for (double area : m_areas)
      m_area += area;
  }

  std::vector<Point_3> m_points;
  std::vector<Index> m_corner_begin = std::vector<Index>(1, 0);
  std::vector<Index> m_corner_vertices;
  std::vector<Index> m_corner_neighbors;
  std::vector<Index> m_patches;     // of the faces, or none
  std::vector<Point_3> m_centroids; // unless all faces are triangles, of which they are found in no time
  std::vector<double> m_areas;
  double m_area = 0;
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_INDEXED_SURFACE_H
