// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_JOIN_PIECES_H
#define CGAL_PROTRUSION_SEGMENTATION_JOIN_PIECES_H

#include <CGAL/Protrusion_segmentation/Joined_pieces.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/write_manifold_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/wrap_pieces.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <optional>
#include <utility>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

makes one closed surface around polygons that are loose pieces of a shape, as in models of games, so that they are
segmented as one shape: pieces that touch, overlap or come nearer than a gap to each other are one, and what lies hidden
inside gets the label of what covers it. The surface is an \ref PkgAlphaWrap3 "alpha wrap". `Joined_pieces` brings labels
back to the polygons.

\tparam PointRange a model of `ConstRange`. Without `point_map`, its value type is a point type with `x()`, `y()` and
       `z()`.
\tparam PolygonRange a model of `ConstRange` whose value type is a model of `ConstRange` of any integer type
\tparam FaceGraph a model of `MutableFaceGraph` with a point for each vertex, whose type has a constructor from three `double`
\tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters2 the same

\param points the points
\param polygons the corners of every polygon, as indices of `points`, in any orientation
\param output the mesh to which vertices and faces are added: triangles, about a third of the gap long, about 150,000 at most
\param gap the distance up to which pieces are joined, above 0 and at most the diagonal of the bounding box; nothing: a
       fortieth of it. Openings that are narrower are closed, too; if the gap is less than about a hundredth, openings up to such a
       share of a shape are closed, more if there are many shapes.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" for the points: `point_map`
\param output_np an optional sequence of \ref bgl_namedparameters "Named Parameters" for `output`: `vertex_point_map`

\return which polygon is nearest to which face

\throw std::invalid_argument if a coordinate of a corner is not finite, if a corner is no index of a point, if no polygon has an
       area, or if the gap is out of range; nothing is added to `output` then

Complexity: the number of triangles grows with the square of the size over the gap, up to that limit; each takes logarithmic
time in the number of polygons. With a narrower gap, the pairs of triangles whose boxes are nearer than the gap are looked at.
*/
template <typename PointRange,
          typename PolygonRange,
          typename FaceGraph,
          typename CGAL_NP_TEMPLATE_PARAMETERS_1,
          typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Joined_pieces<FaceGraph> join_pieces(const PointRange& points,
                                     const PolygonRange& polygons,
                                     FaceGraph& output,
                                     std::optional<double> gap = std::nullopt,
                                     const CGAL_NP_CLASS_1& np = parameters::default_values(),
                                     const CGAL_NP_CLASS_2& output_np = parameters::default_values())
{
  internal::Wrapped_pieces wrapped = internal::wrap_pieces(
    internal::read_polygon_soup(points, internal::point_map_of<PointRange>(np), polygons), gap);
  Joined_pieces<FaceGraph> result;
  static_cast<Polygon_soup_correspondence<FaceGraph>&>(result) = internal::write_manifold_surface(
    wrapped.points, Identity_property_map<internal::Polygon_soup::Point_3>(), std::move(wrapped.surface),
    output, output_np);
  result.point_of_vertex.clear();
  result.piece_of_polygon = std::move(wrapped.piece_of_polygon);
  result.area_of_polygon = std::move(wrapped.area_of_polygon);
  return result;
}

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_JOIN_PIECES_H
