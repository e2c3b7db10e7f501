// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_CLOSED_SEGMENTS_WITH_CONNECTORS_H
#define CGAL_PROTRUSION_SEGMENTATION_CLOSED_SEGMENTS_WITH_CONNECTORS_H

#include <CGAL/Protrusion_segmentation/Closed_segment.h>
#include <CGAL/Protrusion_segmentation/Connector.h>
#include <CGAL/Protrusion_segmentation/Connector_options.h>
#include <CGAL/Protrusion_segmentation/Segmentation_record.h>
#include <CGAL/Protrusion_segmentation/internal/Closing/parts_with_connectors.h>
#include <CGAL/Protrusion_segmentation/internal/Mesh/mesh_to_close.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationRef

makes closed surfaces of segments as `closed_segments()` does, with pegs and sockets that hold them together, as for printing.

On each flat cap that two segments share, one gets a peg and the other a socket, which is wider by the tolerance.
The protrusion has the peg and its parent the socket, or the other way round if only the protrusion has room for the whole depth. The cap
becomes flat around the peg, and its normal is that of the border. Around sockets there are walls of at least a quarter of the
radius of the peg. Caps that are too small, too far from flat, or have too little room behind them stay as they
are; the result says so for each.

All segments are closed as those of `closed_segments()` are. The volumes of two segments add up to those without connectors but
for the gap: the volume of the socket less that of the peg. A peg or a socket cuts neither the surface nor another
cap or connector; a cap cuts no more of its segments than the flat one does.

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph` with a point for each vertex
\tparam SegmentMap a model of `ReadablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key type
                   and an integral value type
\tparam OutputIterator a model of `OutputIterator` that accepts a `Protrusion_segmentation::Closed_segment` of the
                       type of the points, which has a constructor from three `double`
\tparam ConnectorIterator a model of `OutputIterator` that accepts a `Protrusion_segmentation::Connector` of the same
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param pmesh the mesh. Faces may be any polygons; there may be boundaries and several components. Without a
             closed surface around a cap, it gets no connector.
\param segment_ids the segment of every face, from 0
\param record what a segmentation of the mesh found. Only segments and their parents matter here.
\param options the shape of pegs and sockets
\param segments where the closed segments are written, in the order of their ids
\param connectors where one record for each cap is written, in the order of the protrusions
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` as for
          `segmentation_via_protrusion_tips()`

\return `segments`, advanced

\throw std::invalid_argument if a coordinate is not finite or an option is out of range

Complexity: that of `closed_segments()`, and linear in the number of faces for each cap.
*/
template <typename FaceGraph,
          typename SegmentMap,
          typename OutputIterator,
          typename ConnectorIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
OutputIterator closed_segments_with_connectors(const FaceGraph& pmesh,
                                               SegmentMap segment_ids,
                                               const Segmentation_record<FaceGraph>& record,
                                               const Connector_options& options,
                                               OutputIterator segments,
                                               ConnectorIterator connectors,
                                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  const internal::Copy_to_close copy(pmesh, segment_ids, record, internal::vertex_point_map(pmesh, np));
  const internal::Parts_with_connectors found = internal::parts_with_connectors(
    copy.mesh(), copy.segment_of_face(), copy.parents(), options);
  for (const auto& polygons : found.parts.polygons)
    *segments++ = copy.segment(polygons, found.parts.points);
  for (const auto& connector : found.connectors)
    *connectors++ = Connector<typename decltype(copy)::Point>{connector.segment,
                                                              connector.parent,
                                                              connector.status,
                                                              connector.cap_radius,
                                                              connector.is_peg_on_segment,
                                                              copy.to_point(connector.base),
                                                              copy.to_point(connector.end),
                                                              connector.radius,
                                                              connector.depth,
                                                              connector.tolerance};
  return segments;
}

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_PROTRUSION_SEGMENTATION_CLOSED_SEGMENTS_WITH_CONNECTORS_H
