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

namespace CGAL {
namespace Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

makes a mesh of polygons that need not fit together, so that it can be segmented, and tells how its faces belong to
the polygons, so that every polygon gets a label.

`Polygon_mesh_processing::polygon_soup_to_polygon_mesh()` needs polygons that make up an oriented manifold, and
`Polygon_mesh_processing::orient_polygon_soup()` takes a surface apart at an edge of more than two polygons. A
segmentation needs surfaces that hang together: one doubled polygon may not blow them apart. This function works in
five steps:

- A polygon with fewer than three different corners is left out. Its label is that of a neighbor: of the face that
  shares the most corners with it, or else of the face before it.
- Of polygons with the same corners, in the same order or reversed, the first one becomes a face and labels the
  others.
- Polygons are joined along their edges: first where exactly two polygons name the same two points, then where exactly
  two have edges at the same coordinates, so that a soup without shared points hangs together, too. Where more
  polygons meet at an edge, those two are joined that go on the most smoothly, then the next two. Walls, that is
  polygons with a duplicate, come last there.
- Polygons are turned over so that all that are joined are oriented alike, as few as possible in each component. What
  cannot be oriented, as a Moebius strip, stays apart at some edges. A point at which several fans of faces meet gets
  a vertex for each of them.
- *Specks* are left out, and labelled by a neighbor: components with less than a thousandth of the whole area, and
  walls between two solids, that share a point with what remains. A component that touches nothing is kept, however
  small.

Points are at the same place if their coordinates are equal, after conversion to `double` by `CGAL::to_double()`:
nothing is merged within a tolerance. Every polygon that is not left out becomes one face, with its corners; a corner
that follows itself is named once. If nothing has to be repaired, the mesh has the polygons and those points that are
corners, in their order. Among several duplicates, and among pairs that go on equally smoothly, the order of the
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
\cgalNamedParamsEnd

\return which polygon became which face, and what had to be repaired

\throw std::invalid_argument if a coordinate of a corner is not finite, if a corner is no index of a point, if there are no
       polygons, or if none has three different corners; nothing is added to `output` then

Complexity: O(n log n) for n corners of polygons and points, and the square of the number of faces around a vertex, which
shows from ten thousands on. Where vertices would have two faces on one side of an edge, or a face twice, joined edges are
parted again in rounds of the same complexity, until there are no more.
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
  return internal::write_manifold_surface(points, point_map, internal::manifold_surface(std::move(soup)),
                                          output, output_np);
}

} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_POLYGON_SOUP_TO_MANIFOLD_MESH_H
