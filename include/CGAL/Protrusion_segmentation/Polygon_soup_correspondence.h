// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_POLYGON_SOUP_CORRESPONDENCE_H
#define CGAL_PROTRUSION_SEGMENTATION_POLYGON_SOUP_CORRESPONDENCE_H

#include <CGAL/Protrusion_segmentation/Polygon_soup_repairs.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

The result of `polygon_soup_to_manifold_mesh()`: which polygon became which face, which point became which
vertex, and what had to be repaired. Polygons and points are numbered in the order of their ranges, from 0.

\tparam FaceGraph the type of the mesh
*/
template <typename FaceGraph>
struct Polygon_soup_correspondence
{
  /// a face of the mesh
  using face_descriptor = typename boost::graph_traits<FaceGraph>::face_descriptor;
  /// a vertex of the mesh
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;

  /// for every polygon the face that gives it its label: its own, or, if it was left out, that of a duplicate or a
  /// neighbor
  std::vector<face_descriptor> face_of_polygon;
  /// the faces, in the order in which they were added to the mesh, which is that of their polygons
  std::vector<face_descriptor> faces;
  /// for every one of `faces` its polygon
  std::vector<std::size_t> polygon_of_face;
  /// the vertices, in the order in which they were added to the mesh, which is that of their points
  std::vector<vertex_descriptor> vertices;
  /// for every one of `vertices` its point. A point at which several fans of faces meet has several vertices, one
  /// that is a corner of no face has none.
  std::vector<std::size_t> point_of_vertex;
  /// what had to be repaired
  Polygon_soup_repairs repairs;

  /// writes a label for every polygon, from labels of the faces.
  /// \tparam FaceMap a model of `ReadablePropertyMap` with `face_descriptor` as key type
  /// \tparam OutputIterator a model of `OutputIterator` that accepts the value type of `FaceMap`
  /// \param labels the labels of the faces
  /// \param out where the labels of the polygons are written, in the order of the polygons
  /// \return `out`, advanced
  template <typename FaceMap, typename OutputIterator>
  OutputIterator labels_of_polygons(FaceMap labels, OutputIterator out) const
  {
    for (const face_descriptor f : face_of_polygon)
      *out++ = get(labels, f);
    return out;
  }
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_POLYGON_SOUP_CORRESPONDENCE_H
