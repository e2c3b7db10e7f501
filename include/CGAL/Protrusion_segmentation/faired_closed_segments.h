// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_FAIRED_CLOSED_SEGMENTS_H
#define CGAL_PROTRUSION_SEGMENTATION_FAIRED_CLOSED_SEGMENTS_H

#if defined(CGAL_EIGEN3_ENABLED) || defined(DOXYGEN_RUNNING)

#include <CGAL/Protrusion_segmentation/Closed_segment.h>
#include <CGAL/Protrusion_segmentation/Segmentation_record.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/parts_with_faired_caps.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/mesh_to_close.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

makes a surface of triangles of each segment and closes it where it was cut off, by rounded caps.

Each segment has caps of its own, which continue its surface; so the volumes do not add up. Polygons become triangles. A hole that
touches the boundary of the mesh stays open. Requires the library Eigen.

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

Complexity: cubic in the number of edges of each border.
*/
template <typename FaceGraph,
          typename SegmentMap,
          typename OutputIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
OutputIterator faired_closed_segments(const FaceGraph& pmesh,
                                      SegmentMap segment_ids,
                                      const Segmentation_record<FaceGraph>& record,
                                      OutputIterator segments,
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  const internal::Copy_to_close copy(pmesh, segment_ids, record, internal::vertex_point_map(pmesh, np));
  for (const auto& part : internal::faired_caps::parts_with_faired_caps(
         copy.mesh(), copy.segment_of_face(), copy.parents().size()))
  {
    Closed_segment<typename decltype(copy)::Point> segment;
    for (const auto& point : part.points)
      segment.points.push_back(copy.to_point(point));
    segment.polygons = part.polygons;
    *segments++ = segment;
  }
  return segments;
}

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_PROTRUSION_SEGMENTATION_FAIRED_CLOSED_SEGMENTS_H
