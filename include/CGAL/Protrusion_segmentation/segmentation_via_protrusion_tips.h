// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_VIA_PROTRUSION_TIPS_H
#define CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_VIA_PROTRUSION_TIPS_H

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

splits a surface mesh into a body and its protrusions, by `Protrusion_segmentation::Minimum_cut_method`. The method finds
the number of segments: it stops if no protrusion remains.

Segment ids are 0 to n-1, where n is the returned number. The first ids are those of the bodies, one in each connected
component, that of the largest component first. The others are those of protrusions. The last ones are those that `protrusion_hierarchy()` joins first. The
ids depend on the positions of the faces and not on the order of `faces(pmesh)`, except for faces with the same centroid.

Every segment is a connected set of faces, except for <em>small components</em>, such as the dust of a scanner. These are
connected components with less than a thousandth of the area of the largest one and fewer faces. They get no segments of
their own. All other components are segmented as if there were no small ones. A small component gets the segment of the
nearest face of the others, measured from the centroids of its faces. The function `on_small_components()` of a visitor tells
their number.

Nor has the wall of a <em>cavity</em> segments of its own: a closed component that lies inside another one and looks the other
way. Each of its faces gets the segment of the nearest face of the wall around it, so that segments are hollow bodies. A
solid inside the cavity is a component again.

For `Minimum_cut_method`, the body is the segment in the middle: without it, every connected piece of the component has
at most half of its area. For `Histogram_method`, the protrusion is the side of the tip, and the body is the rest.

Coordinates are converted to `double` by `CGAL::to_double()`, whatever the kernel of the points is; those of an exact
kernel are rounded.

\tparam ConcurrencyTag `Sequential_tag`, the default, or `Parallel_tag`, which needs oneTBB. The segments are the
                       same.
\tparam FaceGraph a model of `FaceListGraph` with a point for each vertex
\tparam SegmentMap a model of `WritablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor`
                   as key type and an integer type as value type that is wide enough for the ids
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param pmesh the mesh. Faces may be any polygons; there may be borders and several components.
\param segment_ids the segment of every face, from 0 to n-1; written only if the function succeeds
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
    \cgalParamDescription{the seed of all random choices, such as the landmarks of
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
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{a number for each face, equal for the faces of a patch, such as a loose piece that
                          `Protrusion_segmentation::join_pieces()` has joined to others. `Minimum_cut_method` prefers
                          borders between patches; other methods do not use it.}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor`
                   as key type and an integer type as value type}
    \cgalParamDefault{the whole surface is one patch}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told of the progress and of what was found, and can stop the function. It is
                          copied unless it is passed by `std::ref()`.}
    \cgalParamType{a class model of `ProtrusionSegmentationVisitor`, such as
                   `Protrusion_segmentation::Segmentation_record<FaceGraph>`}
    \cgalParamDefault{`Protrusion_segmentation::Segmentation_visitor<FaceGraph>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of segments; 0 if and only if the mesh has no faces

\throw std::invalid_argument if a coordinate of a vertex with a face is not finite, or if the value type of `segment_ids` is
       too narrow for the ids
\throw std::length_error if the faces have 2<sup>32</sup> - 1 corners or more
\throw Protrusion_segmentation::Segmentation_stopped if the visitor stops the function

Complexity: that of the method.
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename SegmentMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t segmentation_via_protrusion_tips(const FaceGraph& pmesh,
                                             SegmentMap segment_ids,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::segment_mesh<ConcurrencyTag>(
    pmesh, segment_ids, std::nullopt, Protrusion_segmentation::Minimum_cut_method(), np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into `number_of_segments` segments, by `Protrusion_segmentation::Minimum_cut_method`.

There are fewer segments if no more borders are found, and more only if there are more connected components: each of them
has at least one segment.

\tparam ConcurrencyTag, FaceGraph, SegmentMap, NamedParameters as for the function without a number
\tparam Number any integer type

\param number_of_segments the number of segments, from 1 to the number of faces
\param pmesh, segment_ids, np as for the function without a number

\return the number of segments

\throw std::invalid_argument as the function without a number, and if `number_of_segments` is out of its range
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
  return Protrusion_segmentation::internal::segment_mesh<ConcurrencyTag>(
    pmesh, segment_ids, number_of_segments, Protrusion_segmentation::Minimum_cut_method(), np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into a body and its protrusions, by a method of choice. The method finds the number of segments:
it stops if no protrusion remains, the first criterion of Section III of the paper.

\tparam ConcurrencyTag, FaceGraph, SegmentMap, NamedParameters as for the function without a method
\tparam Method `Protrusion_segmentation::Minimum_cut_method` or `Protrusion_segmentation::Histogram_method`

\param method the method with its options and its distance, for instance a `Protrusion_segmentation::Histogram_method`
       that is made from a `Protrusion_segmentation::Landmark_geodesic_distance`. Its header is included separately.
\param pmesh, segment_ids, np as for the function without a method

\return the number of segments; 0 if and only if the mesh has no faces

\throw std::invalid_argument as the function without a method, and if a distance of a user gives a number that is negative
       or no number
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
  return Protrusion_segmentation::internal::segment_mesh<ConcurrencyTag>(pmesh, segment_ids, std::nullopt,
                                                                         method, np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into `number_of_segments` segments, by a method of choice.

\tparam ConcurrencyTag, FaceGraph, SegmentMap, NamedParameters as for the function without number and method
\tparam Number any integer type
\tparam Method as for the function with a method

\param number_of_segments the number of segments, from 1 to the number of faces
\param method the method with its options and its distance
\param pmesh, segment_ids, np as for the function without number and method

\return the number of segments, as for the function with a number

\throw std::invalid_argument as the functions with a number and with a method
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
  return Protrusion_segmentation::internal::segment_mesh<ConcurrencyTag>(pmesh, segment_ids,
                                                                         number_of_segments, method, np);
}

#ifndef DOXYGEN_RUNNING
// What no function above accepts, with the reason in one line.
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename SegmentMap,
          typename... Others>
std::size_t segmentation_via_protrusion_tips(const FaceGraph&, SegmentMap, const Others&...)
{
  static_assert(
    sizeof...(Others) > 100,
    "what follows segment_ids must be a number of segments, a method, or both, and then named "
    "parameters; "
    "a distance belongs to a method, as in Histogram_method(Landmark_geodesic_distance(0.1))");
  return 0;
}
#endif

} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_SEGMENTATION_VIA_PROTRUSION_TIPS_H
