// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_POLYGON_SOUP_TO_MANIFOLD_MESH_H
#define CGAL_PROTRUSION_SEGMENTATION_POLYGON_SOUP_TO_MANIFOLD_MESH_H

#include <CGAL/Protrusion_segmentation/Polygon_soup_correspondence.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/read_polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/write_manifold_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/Polygon_soup.h>
#include <CGAL/Protrusion_segmentation/internal/Repair/manifold_surface.h>

#include <CGAL/Named_function_parameters.h>

#include <utility>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

makes a mesh that can be segmented from any polygons, and tells which face belongs to which polygon, so that every
polygon gets a label.

`Polygon_mesh_processing::polygon_soup_to_polygon_mesh()` needs polygons that are an oriented manifold, and
`Polygon_mesh_processing::orient_polygon_soup()` separates all polygons at an edge of more than two. A segmentation needs
connected surfaces, in which one duplicate polygon must not separate its neighbors. This function works in six steps:

- A polygon with fewer than three different corners is left out. Its label is that of a neighbor: of the face that
  shares the most corners with it, or else of the face before it.
- Of duplicate polygons, which have the same corners in the same order or reversed, the first one becomes a face. The
  others get its label. Polygons of different closed surfaces are no duplicates: where solids touch, each has a wall of its
  own. A closed surface that lies on another one with all its polygons is a duplicate.
- Polygons are joined along their edges: first where exactly two polygons have the same two points, then where exactly
  two have edges with the same coordinates, so that polygons without shared points are connected, too. If more polygons
  meet at an edge, those are joined between which a solid lies, as their orientations tell. If these do not fit, the two
  with the smallest angle between them are joined, then the next two, polygons with a duplicate last.
- Polygons are reversed so that joined ones have the same orientation, as few as possible in each component. A surface
  without an orientation, such as a Moebius strip, is cut at some edges. A point at which several fans of faces meet
  gets a vertex for each of them.
- <em>Small components</em> are left out, and get the label of a neighbor: components with less than a thousandth of the whole area,
  and single walls between two solids, if they share a point with the rest. A component that touches nothing is kept, however
  small.

- Borders that remain are sewn where they nearly agree, and the steps before are repeated: corners that are no farther
  from each other than `snapping_tolerance` become one, unless an edge would vanish, and corners in the middle of an edge
  of another border are set into it, so that cracks are closed.

Points are at the same place if their coordinates are equal, after conversion to `double` by `CGAL::to_double()`. Every
polygon that is not left out becomes one face, with its corners; a corner that follows itself is named once. If nothing has to be repaired, the mesh has the polygons and those points that are
corners, in their order. Among several duplicates, and among pairs with equal angles, the order of the
polygons decides.

\tparam PointRange a model of `ConstRange`. Without `point_map`, its value type is a point type with `x()`, `y()` and
       `z()`.
\tparam PolygonRange a model of `ConstRange` whose value type is a model of `ConstRange` of any integer type
\tparam FaceGraph a model of `MutableFaceGraph` with a point for each vertex, whose type is that of `points` or has a
                  constructor from three `double`
\tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParameters2 the same

\param points the points
\param polygons the corners of every polygon, as indices of `points`, in the order in which they run around it
\param output the mesh to which vertices and faces are added
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" for the points
\param output_np an optional sequence of \ref bgl_namedparameters "Named Parameters" for `output`: `vertex_point_map`

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating points to the elements of `points`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the value type of `PointRange` as key type and a
                   point type with `x()`, `y()` and `z()` as value type}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{snapping_tolerance}
    \cgalParamDescription{the distance up to which borders are sewn, at least 0; 0 sews nothing}
    \cgalParamType{a number type}
    \cgalParamDefault{four millionths of the size of the bounding box or, if that is more and all coordinates are of single
                      precision, four units in the last place of the largest one}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return which polygon became which face, and what had to be repaired

\throw std::invalid_argument if a coordinate of a corner is not finite, if a corner is no index of a point, if there are no
       polygons, if none has three different corners, or if the tolerance is no distance; nothing is added to `output` then

Complexity: O(n log n) for n corners of polygons and points, and the square of the number of faces around a vertex. Edges
whose joining would make the mesh non-manifold are separated again; each pass has the same complexity.
*/
template <typename PointRange,
          typename PolygonRange,
          typename FaceGraph,
          typename CGAL_NP_TEMPLATE_PARAMETERS_1,
          typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Polygon_soup_correspondence<FaceGraph> polygon_soup_to_manifold_mesh(
  const PointRange& points,
  const PolygonRange& polygons,
  FaceGraph& output,
  const CGAL_NP_CLASS_1& np = parameters::default_values(),
  const CGAL_NP_CLASS_2& output_np = parameters::default_values())
{
  const auto point_map = internal::point_map_of<PointRange>(np);
  internal::Polygon_soup soup = internal::read_polygon_soup(points, point_map, polygons);
  return internal::write_manifold_surface(
    points, point_map, internal::manifold_surface(std::move(soup), internal::snapping_tolerance(np)),
    output, output_np);
}

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_POLYGON_SOUP_TO_MANIFOLD_MESH_H
