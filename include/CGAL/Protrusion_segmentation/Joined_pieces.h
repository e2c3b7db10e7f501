// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_JOINED_PIECES_H
#define CGAL_PROTRUSION_SEGMENTATION_JOINED_PIECES_H

#include <CGAL/Protrusion_segmentation/Polygon_soup_correspondence.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/labels_of_pieces.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

The result of `join_pieces()`: which face of the surface around the pieces is nearest to which polygon, and the pieces.
`vertices` have no points, so that `point_of_vertex` is empty; `polygon_of_face` has the nearest polygons.

\tparam FaceGraph the type of the mesh
*/
template <typename FaceGraph>
struct Joined_pieces : Polygon_soup_correspondence<FaceGraph>
{
  /// the type of a face of the mesh
  using face_descriptor = typename Polygon_soup_correspondence<FaceGraph>::face_descriptor;

  /// for every polygon a number that all polygons of its piece have
  std::vector<std::size_t> piece_of_polygon;
  /// the area of every polygon, in any unit
  std::vector<double> area_of_polygon;

  /// writes a label for every polygon, from labels of the faces: that of the nearest face, or, if four fifths of its piece have
  /// one label, this one. Every label of a face is that of a polygon, if there are polygons enough.
  /// \tparam FaceMap a model of `ReadablePropertyMap` with `face_descriptor` as key type and an integer type as value type
  /// \tparam OutputIterator a model of `OutputIterator` that accepts `std::size_t`
  /// \param labels the labels of the faces
  /// \param out where the labels of the polygons are written, in the order of the polygons
  /// \return `out`, advanced
  template <typename FaceMap, typename OutputIterator>
  OutputIterator labels_of_polygons(FaceMap labels, OutputIterator out) const
  {
    std::vector<std::size_t> of_faces, face_of_polygon;
    std::unordered_map<face_descriptor, std::size_t> number;
    for (const face_descriptor f : this->faces)
    {
      number.emplace(f, of_faces.size());
      of_faces.push_back(static_cast<std::size_t>(get(labels, f)));
    }
    for (const face_descriptor f : this->face_of_polygon)
      face_of_polygon.push_back(number.at(f));
    const std::vector<std::size_t> result = internal::labels_of_pieces(
      of_faces, face_of_polygon, this->polygon_of_face, piece_of_polygon, area_of_polygon);
    return std::copy(result.begin(), result.end(), out);
  }

  /// writes the piece that is nearest to every face, for the named parameter `face_patch_map` of
  /// `CGAL::segmentation_via_protrusion_tips()`: then borders of segments are preferred where pieces meet.
  /// \tparam FaceMap a model of `WritablePropertyMap` with `face_descriptor` as key type and an integer type as value type
  /// \param pieces the output
  template <typename FaceMap>
  void pieces_of_faces(FaceMap pieces) const
  {
    using Piece = typename boost::property_traits<FaceMap>::value_type;
    for (std::size_t i = 0; i < this->faces.size(); ++i)
      put(pieces, this->faces[i], static_cast<Piece>(piece_of_polygon[this->polygon_of_face[i]]));
  }
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_JOINED_PIECES_H
