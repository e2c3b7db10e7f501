// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a segmentation of a mesh is from a reference segmentation, such as one made by a human:
// the four metrics of
//
//   Xiaobai Chen, Aleksey Golovinskiy and Thomas Funkhouser: A Benchmark for 3D Mesh Segmentation.
//   ACM Transactions on Graphics 28(3), 2009
//
// with the values that the evaluation program of that benchmark computes.

#ifndef CGAL_SEGMENTATION_METRICS_H
#define CGAL_SEGMENTATION_METRICS_H

#include <CGAL/Protrusion_segmentation/internal/Metrics/Segment_overlap.h>
#include <CGAL/Protrusion_segmentation/internal/Metrics/border_distances.h>
#include <CGAL/Protrusion_segmentation/internal/Metrics/face_measures.h>
#include <CGAL/Protrusion_segmentation/internal/Metrics/overlap_errors.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <optional>

namespace CGAL {
namespace Protrusion_segmentation {

/*!
 * \ingroup PkgProtrusionSegmentationMetrics
 *
 * all metrics of a segmentation against a reference. Smaller is better in each of them.
 */
struct Segmentation_metrics
{
  /// see `CGAL::rand_index_error()`
  double rand_index_error = 0;
  /// see `CGAL::hamming_distance()`
  Hamming_distance hamming_distance;
  /// see `CGAL::cut_discrepancy()`; has no value where it is undefined
  std::optional<double> cut_discrepancy;
  /// see `CGAL::consistency_error()`
  Consistency_error consistency_error;
};

} // namespace Protrusion_segmentation

/*!
 * \defgroup PkgProtrusionSegmentationMetrics Metrics of Segmentations
 * \ingroup PkgProtrusionSegmentationRef
 *
 * Distances between two segmentations of one mesh. They agree in the following.
 *
 * - A segmentation is a property map from the faces to an integral type. A segment is the set of
 *   all faces of one id, connected or not. The ids need be neither consecutive nor positive,
 *   and the ids of the two segmentations need not correspond.
 * - The mesh may have any number of connected components, with boundary or without, and faces with
 *   any number of corners. The area of a face that is not plane is that of its projection along its
 *   mean normal (half the length of its area vector).
 * - Coordinates may be of any number type and are converted with `CGAL::to_double()`;
 *   they must be finite.
 * - On an empty mesh the two segmentations agree: all errors are 0, and the cut discrepancy has no
 *   value. The same holds for what is weighted by area on a mesh without area.
 *
 * No single one of them suffices: a mesh left in one piece has a Hamming distance that beats many a
 * serious segmentation, and a consistency error of 0. Look at the Rand index error first, and at
 * the missing rate and the false-alarm rate next to it.
 */

/*!
 * \ingroup PkgProtrusionSegmentationMetrics
 *
 * returns the fraction of all pairs of faces on which two segmentations disagree: those that lie in
 * one segment in one of them, and in two segments in the other. This is one minus the Rand index.
 *
 * Faces are counted, not weighted. The two segmentations may be exchanged.
 * As in the benchmark's program, the number of pairs by which it divides is
 * <i>n</i> &lfloor;(<i>n</i> - 1) / 2&rfloor;, that is short of the number of pairs by the factor
 * 1 - 1 / (<i>n</i> - 1) if the number of faces <i>n</i> is even. Values that get above 1
 * by that are cut to 1; two faces are taken as one pair.
 *
 * \tparam FaceGraph a model of `FaceListGraph`
 * \tparam SegmentIdMap a model of `ReadablePropertyMap` with
 *         `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and any integral type as
 *         value type
 * \tparam ReferenceIdMap the same; the value type may be another one
 *
 * \param mesh the mesh
 * \param segment_ids the segmentation
 * \param reference_ids the segmentation that it is compared to
 *
 * \return a number in [0, 1]; 0 if and only if the segmentations are the same up to the ids
 *
 * Complexity: linear in the number of faces, in expectation.
 */
template <typename FaceGraph, typename SegmentIdMap, typename ReferenceIdMap>
double rand_index_error(const FaceGraph& mesh,
                        const SegmentIdMap& segment_ids,
                        const ReferenceIdMap& reference_ids)
{
  namespace internal = Protrusion_segmentation::internal;

  return internal::rand_index_error(internal::segment_overlap(mesh, segment_ids, reference_ids));
}

/*!
 * \ingroup PkgProtrusionSegmentationMetrics
 *
 * returns the area on which two segmentations differ when each segment of one is matched to the
 * segment of the other that covers it best, as a fraction of the area of the mesh.
 *
 * The missing rate matches each segment of the reference and grows where the segmentation is too
 * fine; the false-alarm rate matches each segment of the segmentation and grows where it is too
 * coarse. A segment may be matched many times. The distance is the mean of the two rates.
 * Exchanging the segmentations exchanges the two rates and keeps the distance.
 *
 * \tparam FaceGraph a model of `FaceListGraph`
 * \tparam SegmentIdMap a model of `ReadablePropertyMap` with
 *         `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and any integral type as
 *         value type
 * \tparam ReferenceIdMap the same; the value type may be another one
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param mesh the mesh
 * \param segment_ids the segmentation
 * \param reference_ids the segmentation that it is compared to
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
 *        listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and
 *                    `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return distance, missing rate and false-alarm rate, each in [0, 1)
 *
 * Complexity: linear in the number of faces, in expectation.
 */
template <typename FaceGraph, typename SegmentIdMap, typename ReferenceIdMap,
          typename NamedParameters = parameters::Default_named_parameters>
Protrusion_segmentation::Hamming_distance
hamming_distance(const FaceGraph& mesh,
                 const SegmentIdMap& segment_ids,
                 const ReferenceIdMap& reference_ids,
                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Protrusion_segmentation::internal;

  const auto areas = internal::face_areas(mesh, internal::vertex_point_map(mesh, np));
  return internal::hamming_distance(internal::segment_overlap(mesh, segment_ids, reference_ids,
                                                              areas));
}

/*!
 * \ingroup PkgProtrusionSegmentationMetrics
 *
 * returns how far one segmentation is from being a refinement of the other.
 *
 * A face errs by the fraction of its segment that lies outside its segment of the other
 * segmentation. The global error allows refinement in one direction for the whole mesh, the local
 * error in either direction at each face; so 0 is reached by one segment for the whole mesh, and by
 * as many segments as faces, too. The two segmentations may be exchanged.
 * The errors by area take that fraction by area, but their mean over the faces counts each face
 * once, as the benchmark's program does.
 *
 * \tparam FaceGraph a model of `FaceListGraph`
 * \tparam SegmentIdMap a model of `ReadablePropertyMap` with
 *         `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and any integral type as
 *         value type
 * \tparam ReferenceIdMap the same; the value type may be another one
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param mesh the mesh
 * \param segment_ids the segmentation
 * \param reference_ids the segmentation that it is compared to
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
 *        listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and
 *                    `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the four errors, each in [0, 1)
 *
 * Complexity: linear in the number of faces, in expectation.
 */
template <typename FaceGraph, typename SegmentIdMap, typename ReferenceIdMap,
          typename NamedParameters = parameters::Default_named_parameters>
Protrusion_segmentation::Consistency_error
consistency_error(const FaceGraph& mesh,
                  const SegmentIdMap& segment_ids,
                  const ReferenceIdMap& reference_ids,
                  const NamedParameters& np = parameters::default_values())
{
  namespace internal = Protrusion_segmentation::internal;

  const auto areas = internal::face_areas(mesh, internal::vertex_point_map(mesh, np));
  return internal::consistency_error(internal::segment_overlap(mesh, segment_ids, reference_ids,
                                                               areas));
}

/*!
 * \ingroup PkgProtrusionSegmentationMetrics
 *
 * returns the mean distance between the borders of two segmentations, relative to the size of the
 * mesh.
 *
 * The points of a border are the ends of the edges between faces of different segments. The
 * distance of a point to the borders of the other segmentation is the length of the shortest path
 * along edges of the mesh. The mean is taken over the points of both segmentations together, and is
 * divided by the average radius: the mean distance, weighted by area, between the centroids of
 * the faces and the centroid of the surface. The two segmentations may be exchanged.
 *
 * The result has no value where it is undefined:
 * - if one of the segmentations has no border, as has one segment for the whole mesh,
 *   or if both have none,
 * - if a connected component of the mesh holds a border of one segmentation but none of the other,
 *   which then cannot be reached (the benchmark, whose meshes are connected, does not say),
 * - if the average radius is 0, as on a mesh without area.
 *
 * \tparam FaceGraph a model of `FaceListGraph` and `EdgeListGraph`
 * \tparam SegmentIdMap a model of `ReadablePropertyMap` with
 *         `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and any integral type as
 *         value type
 * \tparam ReferenceIdMap the same; the value type may be another one
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param mesh the mesh
 * \param segment_ids the segmentation
 * \param reference_ids the segmentation that it is compared to
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
 *        listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and
 *                    `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{a property map associating to each vertex of `mesh` a unique index
 *                           between `0` and `num_vertices(mesh) - 1`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and
 *                    `std::size_t` as value type}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a number that is not negative, in average radii; no value where it is undefined
 *
 * Complexity: O(<i>n</i> log <i>n</i>) for <i>n</i> vertices (two runs of Dijkstra's algorithm).
 */
template <typename FaceGraph, typename SegmentIdMap, typename ReferenceIdMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::optional<double> cut_discrepancy(const FaceGraph& mesh,
                                      const SegmentIdMap& segment_ids,
                                      const ReferenceIdMap& reference_ids,
                                      const NamedParameters& np = parameters::default_values())
{
  namespace internal = Protrusion_segmentation::internal;

  return internal::cut_discrepancy(mesh, segment_ids, reference_ids,
                                   internal::vertex_point_map(mesh, np),
                                   CGAL::get_initialized_vertex_index_map(mesh, np));
}

/*!
 * \ingroup PkgProtrusionSegmentationMetrics
 *
 * returns all metrics at once: `rand_index_error()`, `hamming_distance()`, `cut_discrepancy()` and
 * `consistency_error()`, for less than the sum of their times.
 *
 * \param mesh, segment_ids, reference_ids, np as for `cut_discrepancy()`
 *
 * \return the metrics
 *
 * Complexity: that of `cut_discrepancy()`.
 */
template <typename FaceGraph, typename SegmentIdMap, typename ReferenceIdMap,
          typename NamedParameters = parameters::Default_named_parameters>
Protrusion_segmentation::Segmentation_metrics
segmentation_metrics(const FaceGraph& mesh,
                     const SegmentIdMap& segment_ids,
                     const ReferenceIdMap& reference_ids,
                     const NamedParameters& np = parameters::default_values())
{
  namespace internal = Protrusion_segmentation::internal;

  const auto areas = internal::face_areas(mesh, internal::vertex_point_map(mesh, np));
  const internal::Segment_overlap overlap =
    internal::segment_overlap(mesh, segment_ids, reference_ids, areas);

  Protrusion_segmentation::Segmentation_metrics result;
  result.rand_index_error = internal::rand_index_error(overlap);
  result.hamming_distance = internal::hamming_distance(overlap);
  result.cut_discrepancy = CGAL::cut_discrepancy(mesh, segment_ids, reference_ids, np);
  result.consistency_error = internal::consistency_error(overlap);
  return result;
}

} // namespace CGAL

#endif // CGAL_SEGMENTATION_METRICS_H
