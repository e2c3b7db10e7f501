// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_CLOSED_SEGMENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_CLOSED_SEGMENTS_H

#include <CGAL/Protrusion_segmentation/Closed_segment.h>
#include <CGAL/Protrusion_segmentation/Segmentation_record.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/parts_with_flat_caps.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/mesh_to_close.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

makes a surface of each segment and closes it where it was cut off, by flat caps that two segments share.

Where a segment with all that sticks out of it is cut off, both sides get the same cap, turned over. So all segments of a closed mesh
are closed, each edge has two faces that look the same way, and the volumes add up to that of the mesh. Caps add no
vertices, unless a cap without would have an edge that is there already; then it has one in its middle. Caps may
intersect the surface or each other where a border is far from flat. A border that ends at the boundary of the mesh gets no cap.

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph` with a point for each vertex
\tparam SegmentMap a model of `ReadablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key type
                   and an integral value type
\tparam OutputIterator a model of `OutputIterator` that accepts a `Protrusion_segmentation::Closed_segment` of the
                       type of the points, which has a constructor from three `double`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param pmesh the mesh. Faces may be any polygons; there may be boundaries and several components.
\param segment_ids the segment of every face, from 0
\param record what a segmentation of the mesh found. Only segments and their parents matter here.
\param segments where the closed segments are written, in the order of their ids
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` as for
          `segmentation_via_protrusion_tips()`

\return `segments`, advanced

\throw std::invalid_argument if a coordinate is not finite

Complexity: linear in the number of faces for each level of the tree, and cubic in the number of edges of each border; for
borders of more than 500 edges CGAL searches fewer triangulations.
*/
template <typename FaceGraph,
          typename SegmentMap,
          typename OutputIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
OutputIterator closed_segments(const FaceGraph& pmesh,
                               SegmentMap segment_ids,
                               const Segmentation_record<FaceGraph>& record,
                               OutputIterator segments,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  const internal::Copy_to_close copy(pmesh, segment_ids, record, internal::vertex_point_map(pmesh, np));
  const internal::Parts_with_flat_caps parts = internal::parts_with_flat_caps(
    copy.mesh(), copy.segment_of_face(), copy.parents());
  for (const auto& polygons : parts.polygons)
    *segments++ = copy.segment(polygons, parts.points);
  return segments;
}

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_CLOSED_SEGMENTS_H
