// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTATION_METRICS_H
#define CGAL_SEGMENTATION_METRICS_H

#include <CGAL/Protrusion_segmentation/Consistency_error.h>
#include <CGAL/Protrusion_segmentation/Hamming_distance.h>
#include <CGAL/Protrusion_segmentation/Segmentation_metrics.h>
#include <CGAL/Protrusion_segmentation/internal/Metrics/border_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Metrics/face_areas.h>
#include <CGAL/Protrusion_segmentation/internal/Metrics/overlap_errors.h>
#include <CGAL/Protrusion_segmentation/internal/Metrics/segment_id_maps.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <optional>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationMetrics

returns the fraction of all pairs of faces on which two segmentations disagree: those that lie in one segment
in one of them, and in two segments in the other. This is one minus the Rand index.

Faces are counted, not weighted. The two segmentations may be exchanged.

The program of the Princeton Segmentation Benchmark does not divide by the number of pairs of <i>n</i> faces,
<i>n</i> (<i>n</i> - 1) / 2, but by <i>n</i> &lfloor;(<i>n</i> - 1) / 2&rfloor;. To compare the result with figures that
were published with it, multiply it by (<i>n</i> - 1) / (<i>n</i> - 2) if <i>n</i> is even and above 2,
and cut it to 1; the tool `evaluate_segmentation` does.

\tparam FaceGraph a model of `FaceListGraph`
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
                     `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and any integral type as
                     value type
\tparam ReferenceIdMap the same; the value type may be another one

\param pmesh the mesh
\param segment_ids the segmentation
\param reference_ids the segmentation that it is compared to

\return a number in [0, 1]; 0 if and only if the segmentations are the same up to the ids, as they are on a
        mesh with fewer than two faces

Complexity: linear in the number of faces, in expectation.
*/
template <typename FaceGraph, typename SegmentIdMap, typename ReferenceIdMap>
double segmentation_rand_index_error(const FaceGraph& pmesh,
                                     const SegmentIdMap& segment_ids,
                                     const ReferenceIdMap& reference_ids)
{
  if constexpr (internal::are_comparable<FaceGraph, SegmentIdMap, ReferenceIdMap>)
    return internal::rand_index_error(internal::segment_overlap(pmesh, segment_ids, reference_ids));
  else
    return 0;
}

/*!
\ingroup PkgProtrusionSegmentationMetrics

returns the area on which two segmentations differ when each segment of one is matched to the segment of the
other that covers it best, as a fraction of the area of the mesh.

The missing rate matches each segment of the reference and grows where the segmentation is too fine; the
false-alarm rate matches each segment of the segmentation and grows where it is too coarse. A segment may be
matched many times. The distance is the mean of the two rates. Exchanging the segmentations exchanges the two
rates and keeps the distance.

\tparam FaceGraph a model of `FaceListGraph`
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
                     `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and any integral type as
                     value type
\tparam ReferenceIdMap the same; the value type may be another one
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param pmesh the mesh
\param segment_ids the segmentation
\param reference_ids the segmentation that it is compared to
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `pmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and `%Point_3` as value
                   type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, pmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return distance, missing rate and false-alarm rate, each in [0, 1)
\throw std::invalid_argument if a coordinate of a vertex with a face is not finite

Complexity: linear in the number of faces, in expectation.
*/
template <typename FaceGraph,
          typename SegmentIdMap,
          typename ReferenceIdMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Hamming_distance segmentation_hamming_distance(const FaceGraph& pmesh,
                                               const SegmentIdMap& segment_ids,
                                               const ReferenceIdMap& reference_ids,
                                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr (internal::are_comparable<FaceGraph, SegmentIdMap, ReferenceIdMap>)
  {
    const auto areas = internal::face_areas(pmesh, internal::vertex_point_map(pmesh, np));
    return internal::hamming_distance(
      internal::segment_overlap(pmesh, segment_ids, reference_ids, areas));
  }
  else
    return {};
}

/*!
\ingroup PkgProtrusionSegmentationMetrics

returns how far one segmentation is from being a refinement of the other.

A face errs by the fraction of its segment that lies outside its segment of the other segmentation. The global
error allows refinement in one direction for the whole mesh, the local error in either direction at each face;
so 0 is reached by one segment for the whole mesh, and by as many segments as faces, too. The two segmentations
may be exchanged. The errors by area take that fraction by area, but their mean over the faces counts each face
once, as the benchmark's program does.

\tparam FaceGraph a model of `FaceListGraph`
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
                     `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and any integral type as
                     value type
\tparam ReferenceIdMap the same; the value type may be another one
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param pmesh, segment_ids, reference_ids, np as for `segmentation_hamming_distance()`

\return the four errors, each in [0, 1)
\throw std::invalid_argument if a coordinate of a vertex with a face is not finite

Complexity: linear in the number of faces, in expectation.
*/
template <typename FaceGraph,
          typename SegmentIdMap,
          typename ReferenceIdMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Consistency_error segmentation_consistency_error(const FaceGraph& pmesh,
                                                 const SegmentIdMap& segment_ids,
                                                 const ReferenceIdMap& reference_ids,
                                                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr (internal::are_comparable<FaceGraph, SegmentIdMap, ReferenceIdMap>)
  {
    const auto areas = internal::face_areas(pmesh, internal::vertex_point_map(pmesh, np));
    return internal::consistency_error(
      internal::segment_overlap(pmesh, segment_ids, reference_ids, areas));
  }
  else
    return {};
}

/*!
\ingroup PkgProtrusionSegmentationMetrics

returns the mean distance between the borders of two segmentations, relative to the size of the mesh.

The points of a border are the ends of the edges between faces of different segments. The distance of a point
to the borders of the other segmentation is the length of the shortest path along edges of the mesh. The mean
is taken over the points of both segmentations together, and is divided by the average radius: the mean
distance, weighted by area, between the centroids of the faces and the centroid of the surface. The two
segmentations may be exchanged.

The result has no value where it is undefined:
- if one of the segmentations has no border, as has one segment for the whole mesh, or if both have none,
- if a connected component of the mesh holds a border of one segmentation but none of the other, which then
  cannot be reached (the benchmark, whose meshes are connected, does not say),
- if the average radius is 0, as on a mesh without area.

\tparam FaceGraph a model of `FaceListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `VertexListGraph`
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
                     `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and any integral type as
                     value type
\tparam ReferenceIdMap the same; the value type may be another one
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param pmesh the mesh
\param segment_ids the segmentation
\param reference_ids the segmentation that it is compared to
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `pmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and `%Point_3` as value
                   type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, pmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `pmesh` a unique index between `0` and
                          `num_vertices(pmesh) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and `std::size_t` as value
                   type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a number that is not negative, in average radii; no value where it is undefined
\throw std::invalid_argument if both segmentations have a border and a coordinate is not finite

Complexity: O(<i>n</i> log <i>n</i>) for <i>n</i> vertices (two runs of Dijkstra's algorithm).
*/
template <typename FaceGraph,
          typename SegmentIdMap,
          typename ReferenceIdMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::optional<double> segmentation_cut_discrepancy(const FaceGraph& pmesh,
                                                   const SegmentIdMap& segment_ids,
                                                   const ReferenceIdMap& reference_ids,
                                                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr (internal::are_comparable<FaceGraph, SegmentIdMap, ReferenceIdMap>)
    return internal::cut_discrepancy(pmesh, segment_ids, reference_ids,
                                     internal::vertex_point_map(pmesh, np),
                                     CGAL::get_initialized_vertex_index_map(pmesh, np));
  else
    return {};
}

/*!
\ingroup PkgProtrusionSegmentationMetrics

returns how well the parts of a reference are found: the mean, over all parts of the reference, of the largest
intersection over union of the part and any segment. Larger is better.

This is the metric of learned methods. Faces are counted, not weighted. A segment may be the best one for many parts.
Faces of the reference with a negative id belong to no part. The two segmentations may not be exchanged.

\param pmesh, segment_ids, reference_ids as for `segmentation_rand_index_error()`

\return a number in (0, 1]; 1 if and only if each part is a segment, as without any part

Complexity: linear in the number of faces, in expectation.
*/
template <typename FaceGraph, typename SegmentIdMap, typename ReferenceIdMap>
double mean_best_intersection_over_union(const FaceGraph& pmesh,
                                         const SegmentIdMap& segment_ids,
                                         const ReferenceIdMap& reference_ids)
{
  if constexpr (internal::are_comparable<FaceGraph, SegmentIdMap, ReferenceIdMap>)
    return internal::mean_best_intersection_over_union(
      internal::segment_overlap(pmesh, segment_ids, reference_ids),
      internal::segments_that_are_parts(pmesh, reference_ids));
  else
    return 1;
}

/*!
\ingroup PkgProtrusionSegmentationMetrics

returns all of these metrics at once, for less than the sum of their times.

\param pmesh, segment_ids, reference_ids, np as for `segmentation_cut_discrepancy()`

\return the metrics
\throw std::invalid_argument if a coordinate of a vertex with a face is not finite

Complexity: that of `segmentation_cut_discrepancy()`.
*/
template <typename FaceGraph,
          typename SegmentIdMap,
          typename ReferenceIdMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Segmentation_metrics segmentation_metrics(const FaceGraph& pmesh,
                                          const SegmentIdMap& segment_ids,
                                          const ReferenceIdMap& reference_ids,
                                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  Segmentation_metrics result;
  if constexpr (internal::are_comparable<FaceGraph, SegmentIdMap, ReferenceIdMap>)
  {
    const auto areas = internal::face_areas(pmesh, internal::vertex_point_map(pmesh, np));
    const internal::Segment_overlap overlap = internal::segment_overlap(pmesh, segment_ids, reference_ids,
                                                                        areas);
    result.rand_index_error = internal::rand_index_error(overlap);
    result.hamming_distance = internal::hamming_distance(overlap);
    result.cut_discrepancy = Protrusion_segmentation::segmentation_cut_discrepancy(pmesh, segment_ids,
                                                                                   reference_ids, np);
    result.consistency_error = internal::consistency_error(overlap);
    result.mean_best_intersection_over_union = internal::mean_best_intersection_over_union(
      overlap, internal::segments_that_are_parts(pmesh, reference_ids));
  }
  return result;
}

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_SEGMENTATION_METRICS_H
