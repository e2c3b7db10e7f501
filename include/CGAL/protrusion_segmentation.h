// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_H
#define CGAL_PROTRUSION_SEGMENTATION_H

#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Protrusion_segmentation/Landmark_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Minimum_cut_method.h>
#include <CGAL/Protrusion_segmentation/Segment_hierarchy.h>
#include <CGAL/Protrusion_segmentation/Segmentation_visitor.h>
#include <CGAL/Protrusion_segmentation/label_confidence.h>
#include <CGAL/Protrusion_segmentation/internal/segment_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into a body and its protrusions, by a method of choice.

Segment ids are 0 to n-1, where n is the returned number. Every segment is a connected set of faces, but for specks. The
first ids are those of the bodies, one in each connected component, the largest first; the others are those of protrusions, in the order in which
their borders were chosen. The ids depend on where the faces are and not on the order of `faces(pmesh)`, except for
faces with the same centroid.

For `Minimum_cut_method`, the body is the segment in the middle: if it is taken away, every connected piece that is left
of the component has at most half of its area. For `Histogram_method`, the protrusion is the side of the tip, and the
body is what is left in the end.

There are fewer segments than asked for if no more borders are found, and more only if there are more connected
components: each of them has at least one segment.

*Specks*, as dust of a scanner, get no segments of their own: connected components with less than a thousandth of the area of
the largest one and fewer faces. All others are segmented as if there were none, and a speck gets the segment of the nearest
of their faces, from centroid to centroid. `Protrusion_segmentation::Segmentation_visitor::on_specks()` tells their number.

Coordinates are converted to `double` by `CGAL::to_double()`, whatever the kernel of the points is: those of an
exact kernel are rounded.

\tparam ConcurrencyTag `Sequential_tag`, the default, or `Parallel_tag`, which needs oneTBB. The segments are the
                       same.
\tparam FaceGraph a model of `FaceListGraph` with a point for each vertex
\tparam SegmentMap a model of `WritablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor`
                   as key type and an integer type as value type that is wide enough for the ids
\tparam Number any integer type
\tparam Method `Protrusion_segmentation::Minimum_cut_method` or `Protrusion_segmentation::Histogram_method`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param pmesh the mesh. Faces may be any polygons; there may be borders and several components.
\param segment_ids the segment of every face; written only if the function succeeds
\param number_of_segments the number of segments k, from 1 to the number of faces
\param method the method with its options and its distance, for instance a `Protrusion_segmentation::Histogram_method`
       that is made from a `Protrusion_segmentation::Landmark_geodesic_distance`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `pmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and a point type with
                   `x()`, `y()` and `z()` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, pmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of everything random, such as the landmarks of
                          `Protrusion_segmentation::Landmark_geodesic_distance`; the same seed gives the
                          same segments}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{`0`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{an output: set to `true` for the edges between two segments and to `false` for all
                          others, if the function succeeds}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<FaceGraph>::%edge_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{not set}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told of the progress and of what was found, and can stop the function. It is
                          copied unless it is passed by `std::ref()`.}
    \cgalParamType{a class that derives from `Protrusion_segmentation::Segmentation_visitor<FaceGraph>`}
    \cgalParamDefault{`Protrusion_segmentation::Segmentation_visitor<FaceGraph>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of segments, or 0 if the visitor stopped the function, or if the mesh has no faces and no
        number of segments is given; in both cases nothing is written

\throw std::invalid_argument if `number_of_segments` is below 1 or larger than the number of faces, if a
       coordinate is not finite, if the value type of `segment_ids` is too narrow for the ids, or if a distance of a user's gives anything else than numbers from 0 on

Complexity: that of the method.
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename SegmentMap,
          typename Number,
          typename Method,
          typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          ,
          Protrusion_segmentation::internal::If_number<Number> = 0,
          Protrusion_segmentation::internal::If_method<Method> = 0
#endif
          >
std::size_t segmentation_via_protrusion_tips(const FaceGraph& pmesh,
                                             SegmentMap segment_ids,
                                             Number number_of_segments,
                                             const Method& method,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::segment_mesh<ConcurrencyTag>(pmesh, segment_ids, number_of_segments, method, np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into a body and its evident protrusions, by a method of choice. The method stops by itself: the
first criterion of Section III of the paper.

\param pmesh, segment_ids, method, np as for the function with a number of segments and a method
\return as for the function with a number of segments and a method
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename SegmentMap,
          typename Method,
          typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          ,
          Protrusion_segmentation::internal::If_method<Method> = 0
#endif
          >
std::size_t segmentation_via_protrusion_tips(const FaceGraph& pmesh,
                                             SegmentMap segment_ids,
                                             const Method& method,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::segment_mesh<ConcurrencyTag>(pmesh, segment_ids, std::nullopt, method, np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into `number_of_segments` segments by the default method,
`Protrusion_segmentation::Minimum_cut_method`.

\param pmesh, segment_ids, number_of_segments, np as for the function with a number of segments and a method
\return as for the function with a number of segments and a method
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename SegmentMap,
          typename Number,
          typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          ,
          Protrusion_segmentation::internal::If_number<Number> = 0
#endif
          >
std::size_t segmentation_via_protrusion_tips(const FaceGraph& pmesh,
                                             SegmentMap segment_ids,
                                             Number number_of_segments,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return segmentation_via_protrusion_tips<ConcurrencyTag>(pmesh, segment_ids, number_of_segments,
                                                          Protrusion_segmentation::Minimum_cut_method(), np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into a body and its evident protrusions by the default method,
`Protrusion_segmentation::Minimum_cut_method`.

\param pmesh, segment_ids, np as for the function with a number of segments and a method
\return as for the function with a number of segments and a method
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename SegmentMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t segmentation_via_protrusion_tips(const FaceGraph& pmesh,
                                             SegmentMap segment_ids,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return segmentation_via_protrusion_tips<ConcurrencyTag>(pmesh, segment_ids,
                                                          Protrusion_segmentation::Minimum_cut_method(), np);
}

#ifndef DOXYGEN_RUNNING
// What no function above accepts, with the reason in one line.
template <typename ConcurrencyTag = Sequential_tag, typename FaceGraph, typename SegmentMap, typename... Others>
std::size_t segmentation_via_protrusion_tips(const FaceGraph&, SegmentMap, const Others&...)
{
  static_assert(sizeof...(Others) > 100,
                "what follows segment_ids must be a number of segments, a method, or both, and then named parameters; "
                "a distance belongs to a method, as in Histogram_method(Landmark_geodesic_distance(0.1))");
  return 0;
}
#endif

/*!
\ingroup PkgProtrusionSegmentationRef

selects protrusion tips, faces far from each other along the surface.

The first tip is the face with the largest sum of distances to all faces, eq.&nbsp;(1) in Section III.C of the paper.
Every further tip is the face farthest from all tips so far, eq.&nbsp;(2).

If the mesh has several connected components, large ones get more tips: every tip goes to the component with the largest
quotient of its area and the number of tips that it would then have. Specks, as `segmentation_via_protrusion_tips()` defines them,
get none.

\tparam ConcurrencyTag as for `segmentation_via_protrusion_tips()`
\tparam Number any integer type
\tparam OutputIterator a model of `OutputIterator` that accepts
                       `boost::graph_traits<FaceGraph>::%face_descriptor`
\tparam Distance a model of `ProtrusionDistance`

\param pmesh the mesh
\param number_of_tips the number of tips, at most the number of faces
\param tips where the faces at the tips are written, in the order of selection in each component; fewer than
            asked for if all remaining faces are at distance 0 from a tip; none if the visitor stops the function
\param distance the distance on the surface
\param np an optional sequence of named parameters, among `vertex_point_map`, `random_seed` and `visitor` as for
          `segmentation_via_protrusion_tips()`

\return `tips`, advanced

\throw std::invalid_argument if there are more tips than faces, if their number is negative, or if a coordinate is
       not finite

Complexity: one distance computation for each tip, and those that the distance needs for eq. (1).
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
  return Protrusion_segmentation::internal::select_mesh_tips<ConcurrencyTag>(pmesh, number_of_tips, tips, distance, np);
}

#ifndef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag, typename FaceGraph, typename Number, typename OutputIterator, typename... Others>
OutputIterator protrusion_tips(const FaceGraph&, Number, OutputIterator tips, const Others&...)
{
  static_assert(sizeof...(Others) > 100,
                "what follows tips must be a distance, such as Geodesic_distance(), and then named parameters");
  return tips;
}
#endif

/*!
\ingroup PkgProtrusionSegmentationRef

selects protrusion tips by `Protrusion_segmentation::Geodesic_distance`.

\param pmesh, number_of_tips, tips, np as for the function with a distance
\return as for the function with a distance
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
  return protrusion_tips<ConcurrencyTag>(pmesh, number_of_tips, tips, Protrusion_segmentation::Geodesic_distance(),
                                         np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

cuts off the protrusions of given tips, steps 3 and 4 of Section III.A: for tips of `protrusion_tips()`,
edited or picked by a user.

One tip cuts off its protrusion. A tip that is given twice counts once, and so do two tips whose faces share a vertex.
A tip for which no border is found, or that already lies in the protrusion of another one, makes no segment. A tip on a speck
counts as one on the face whose segment the speck gets.

\tparam ConcurrencyTag, FaceGraph, SegmentMap, Method as for `segmentation_via_protrusion_tips()`
\tparam FaceRange a range of `boost::graph_traits<FaceGraph>::%face_descriptor`

\param tips the faces at the tips
\param pmesh, segment_ids, method, np as for `segmentation_via_protrusion_tips()`

\return as for `segmentation_via_protrusion_tips()`; at most one segment for each tip and each component

\throw std::invalid_argument if a face of `tips` is not in `pmesh`, or if a coordinate is not finite

Complexity: that of the method, and with hundreds of tips, above that, linear in their number.
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
  return Protrusion_segmentation::internal::segment_mesh_from_tips<ConcurrencyTag>(pmesh, tips, segment_ids, method,
                                                                                   np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

cuts off the protrusions of given tips by the default method, `Protrusion_segmentation::Minimum_cut_method`.

\param pmesh, tips, segment_ids, np as for the function with a method
\return as for the function with a method
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
  return segmentation_from_protrusion_tips<ConcurrencyTag>(pmesh, tips, segment_ids,
                                                           Protrusion_segmentation::Minimum_cut_method(), np);
}

#ifndef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag, typename FaceGraph, typename FaceRange, typename SegmentMap, typename... Others>
std::size_t segmentation_from_protrusion_tips(const FaceGraph&, const FaceRange&, SegmentMap, const Others&...)
{
  static_assert(sizeof...(Others) > 100,
                "what follows segment_ids must be a method and then named parameters; a distance belongs to a method, as "
                "in Histogram_method(Landmark_geodesic_distance(0.1))");
  return 0;
}
#endif

/*!
\ingroup PkgProtrusionSegmentationRef

computes the hierarchy of nested protrusions by a method of choice: one call that serves every number of segments.

For its maximum number of segments, the hierarchy has the segmentation of `segmentation_via_protrusion_tips()`. Those for
smaller numbers are made from it by joining protrusions to what they stick out of, so that all are nested.
`segmentation_via_protrusion_tips()` for a smaller number may find borders that are better together.

\tparam ConcurrencyTag, FaceGraph, Number, Method as for `segmentation_via_protrusion_tips()`

\param pmesh the mesh
\param maximum_number_of_segments the number of segments of the finest segmentation, from 1 to the number of faces; it
       has fewer if no more borders are found
\param method the method with its options and its distance
\param np an optional sequence of named parameters, among `vertex_point_map`, `random_seed` and `visitor` as
       for `segmentation_via_protrusion_tips()`

\return the hierarchy; an empty one if the visitor stopped the function

\throw std::invalid_argument if `maximum_number_of_segments` is below 1 or larger than the number of faces, or if a
       coordinate is not finite
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename Number,
          typename Method,
          typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          ,
          Protrusion_segmentation::internal::If_method<Method> = 0
#endif
          >
Protrusion_segmentation::Segment_hierarchy protrusion_hierarchy(
  const FaceGraph& pmesh,
  Number maximum_number_of_segments,
  const Method& method,
  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::mesh_hierarchy<ConcurrencyTag>(pmesh, maximum_number_of_segments, method, np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

computes the hierarchy of nested protrusions by the default method, `Protrusion_segmentation::Minimum_cut_method`.

\param pmesh, maximum_number_of_segments, np as for the function with a method
\return as for the function with a method
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename Number,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Protrusion_segmentation::Segment_hierarchy protrusion_hierarchy(
  const FaceGraph& pmesh,
  Number maximum_number_of_segments,
  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return protrusion_hierarchy<ConcurrencyTag>(pmesh, maximum_number_of_segments,
                                              Protrusion_segmentation::Minimum_cut_method(), np);
}

#ifndef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag, typename FaceGraph, typename Number, typename... Others>
Protrusion_segmentation::Segment_hierarchy protrusion_hierarchy(const FaceGraph&, Number, const Others&...)
{
  static_assert(sizeof...(Others) > 100,
                "what follows maximum_number_of_segments must be a method and then named parameters; a distance belongs to a "
                "method, as in Histogram_method(Landmark_geodesic_distance(0.1))");
  return {};
}
#endif

} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_H
