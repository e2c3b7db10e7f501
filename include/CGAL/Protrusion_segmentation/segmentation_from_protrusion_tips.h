// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_FROM_PROTRUSION_TIPS_H
#define CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_FROM_PROTRUSION_TIPS_H

#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Minimum_cut_method.h>
#include <CGAL/Protrusion_segmentation/internal/segment_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <optional>

namespace CGAL {

/*!
\ingroup PkgProtrusionSegmentationRef

selects protrusion tips, faces far from each other along the surface, by `Protrusion_segmentation::Geodesic_distance`.

The first tip is the face with the largest sum of distances to all faces, eq.&nbsp;(1) in Section III.C of the paper.
Every further tip is the face farthest from all tips so far, eq.&nbsp;(2).

If the mesh has several connected components, large ones get more tips: every tip goes to the component with the largest
quotient of its area and the number of tips that it would then have. Small components, as
`segmentation_via_protrusion_tips()` defines them, get none.

\tparam ConcurrencyTag as for `segmentation_via_protrusion_tips()`
\tparam FaceGraph a model of `FaceListGraph` with a point for each vertex
\tparam Number any integer type
\tparam OutputIterator a model of `OutputIterator` that accepts
                       `boost::graph_traits<FaceGraph>::%face_descriptor`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param pmesh the mesh. Faces may be any polygons; there may be borders and several components.
\param number_of_tips the number of tips, from 0 to the number of faces
\param tips the output for the faces at the tips, in the order of selection in each component; fewer than asked for if
       all remaining faces are at distance 0 from a tip
\param np an optional sequence of named parameters, among `vertex_point_map`, `random_seed`, `face_patch_map` and `visitor` as for
          `segmentation_via_protrusion_tips()`. With `edge_is_constrained_map`, the call does not compile.

\return `tips`, advanced

\throw std::invalid_argument if `number_of_tips` is out of its range, or if a coordinate of a vertex with a face is not
       finite; no tips are written then
\throw Protrusion_segmentation::Segmentation_stopped if the visitor stops the function; no tips are written then

Complexity: one distance computation for each tip, and those that the distance needs for eq.&nbsp;(1).
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename Number,
          typename OutputIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
OutputIterator protrusion_tips(const FaceGraph& pmesh,
                               Number number_of_tips,
                               OutputIterator tips,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::select_mesh_tips<ConcurrencyTag>(
    pmesh, number_of_tips, tips, Protrusion_segmentation::Geodesic_distance(), np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

selects protrusion tips by a distance of choice.

\tparam ConcurrencyTag, FaceGraph, Number, OutputIterator, NamedParameters as for the function without a distance
\tparam Distance a model of `ProtrusionDistance`

\param distance the distance on the surface
\param pmesh, number_of_tips, tips, np as for the function without a distance

\return `tips`, advanced

\throw std::invalid_argument as the function without a distance, and if a distance of a user gives a number that is negative
       or no number
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename Number,
          typename OutputIterator,
          typename Distance,
          typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<Protrusion_segmentation::internal::Is_distance<Distance>::value, int> = 0
#endif
          >
OutputIterator protrusion_tips(const FaceGraph& pmesh,
                               Number number_of_tips,
                               OutputIterator tips,
                               const Distance& distance,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::select_mesh_tips<ConcurrencyTag>(pmesh, number_of_tips, tips,
                                                                             distance, np);
}

#ifndef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename Number,
          typename OutputIterator,
          typename... Others>
OutputIterator protrusion_tips(const FaceGraph&, Number, OutputIterator tips, const Others&...)
{
  static_assert(
    sizeof...(Others) > 100,
    "what follows tips must be a distance, such as Geodesic_distance(), and then named parameters");
  return tips;
}
#endif

/*!
\ingroup PkgProtrusionSegmentationRef

cuts off the protrusions of given tips, steps 3 and 4 of Section III.A of the paper, by
`Protrusion_segmentation::Minimum_cut_method`. The tips may be those of `protrusion_tips()`, edited or picked by a user.

One tip cuts off its protrusion. A tip that is given twice counts once, and so do two tips whose faces share a vertex.
A tip for which no border is found, or that already lies in the protrusion of another one, makes no segment. A tip on a small
component counts as one on the face whose segment that component gets.

The tips of all protrusions that `segmentation_via_protrusion_tips()` found by the same method, as a visitor was told of them, give the
same segments. With a few more tips, these add protrusions to them. With some of the tips only, the default method keeps their
segments, and the others go to what they stick out of.

\tparam ConcurrencyTag, FaceGraph, SegmentMap, NamedParameters as for `segmentation_via_protrusion_tips()`
\tparam FaceRange a range of `boost::graph_traits<FaceGraph>::%face_descriptor`

\param tips the faces at the tips, in any order
\param pmesh, segment_ids, np as for `segmentation_via_protrusion_tips()`

\return the number of segments, at most one for each tip and each component; 0 if and only if the mesh has no faces

\throw std::invalid_argument as `segmentation_via_protrusion_tips()`, and if a face of `tips` is not in `pmesh`
\throw Protrusion_segmentation::Segmentation_stopped if the visitor stops the function

Complexity: that of the method, plus a time that is linear in the number of tips.
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename FaceRange,
          typename SegmentMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t segmentation_from_protrusion_tips(const FaceGraph& pmesh,
                                              const FaceRange& tips,
                                              SegmentMap segment_ids,
                                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::segment_mesh_from_tips<ConcurrencyTag>(
    pmesh, tips, segment_ids, Protrusion_segmentation::Minimum_cut_method(), np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

cuts off the protrusions of given tips by a method of choice.

\tparam ConcurrencyTag, FaceGraph, FaceRange, SegmentMap, NamedParameters as for the function without a method
\tparam Method as for `segmentation_via_protrusion_tips()`

\param method the method with its options and its distance
\param pmesh, tips, segment_ids, np as for the function without a method

\return the number of segments, as for the function without a method

\throw std::invalid_argument as the function without a method, and if a distance of a user gives a number that is negative
       or no number
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename FaceRange,
          typename SegmentMap,
          typename Method,
          typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          ,
          Protrusion_segmentation::internal::If_method<Method> = 0
#endif
          >
std::size_t segmentation_from_protrusion_tips(const FaceGraph& pmesh,
                                              const FaceRange& tips,
                                              SegmentMap segment_ids,
                                              const Method& method,
                                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::segment_mesh_from_tips<ConcurrencyTag>(
    pmesh, tips, segment_ids, method, np);
}

#ifndef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename FaceRange,
          typename SegmentMap,
          typename... Others>
std::size_t segmentation_from_protrusion_tips(const FaceGraph&,
                                              const FaceRange&,
                                              SegmentMap,
                                              const Others&...)
{
  static_assert(sizeof...(Others) > 100, "what follows segment_ids must be a method and then named "
                                         "parameters; a distance belongs to a method, as "
                                         "in Histogram_method(Landmark_geodesic_distance(0.1))");
  return 0;
}
#endif

} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_FROM_PROTRUSION_TIPS_H
