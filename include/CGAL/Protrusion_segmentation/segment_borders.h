// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SEGMENT_BORDERS_H
#define CGAL_PROTRUSION_SEGMENTATION_SEGMENT_BORDERS_H

#include <CGAL/Protrusion_segmentation/Segment_border.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/Segment_border_finder.h>
#include <CGAL/Protrusion_segmentation/internal/user_points.h>

#include <CGAL/Named_function_parameters.h>


#include <utility>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

finds the borders between segments as lines of edges. The boundary of the mesh is no border between segments.

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph` with a point for each vertex
\tparam SegmentMap a model of `ReadablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key type
                   and an integral value type
\tparam OutputIterator a model of `OutputIterator` that accepts a `Protrusion_segmentation::Segment_border` of the
                       type of the points
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param pmesh the mesh. Faces may be any polygons; there may be boundaries and several components.
\param segment_ids the segment of every face, from 0
\param borders where the borders are written, sorted by their two segments
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` as for
          `segmentation_via_protrusion_tips()`

\return `borders`, advanced

Throws nothing of its own.

Complexity: linear in the number of edges, and O(n log n) for n borders.
*/
template <typename FaceGraph,
          typename SegmentMap,
          typename OutputIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
OutputIterator segment_borders(const FaceGraph& pmesh,
                               SegmentMap segment_ids,
                               OutputIterator borders,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto points = internal::vertex_point_map(pmesh, np);
  internal::Segment_border_finder finder(pmesh, segment_ids, points);
  for (auto& border : finder.find())
    *borders++ = std::move(border);
  return borders;
}

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_SEGMENT_BORDERS_H
