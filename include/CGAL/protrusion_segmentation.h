// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_H
#define CGAL_PROTRUSION_SEGMENTATION_H

#include <CGAL/Protrusion_segmentation/Default_visitor.h>
#include <CGAL/Protrusion_segmentation/Geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Protrusion_segmentation/Landmark_geodesic_distance.h>
#include <CGAL/Protrusion_segmentation/Minimum_cut_method.h>
#include <CGAL/Protrusion_segmentation/Segment_hierarchy.h>
#include <CGAL/Protrusion_segmentation/internal/segment_mesh.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into a body and its protrusions, with distances and a border method of choice.

Segment ids are 0 to n-1, where n is the returned number. Every segment is a connected set of faces.
Connected components have the first ids. The ids depend on where the faces are and not on the order of
`faces(tmesh)`, except for faces with the same centroid. Every border then splits one segment
in two; the protrusion that it cuts off gets the next id and the rest keeps the old one. For
`Minimum_cut_method` the protrusion is the side of smaller area, for `Histogram_method` the side of the tip. So
what remains of a component in the end, its body, has the id of the component.

A mesh of several connected components has at least as many segments, even if fewer were asked for. It may
have fewer segments than asked for if no more borders are found.

\tparam FaceGraph a model of `FaceListGraph` with a point for each vertex
\tparam SegmentMap a model of `WritablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor`
                   as key type and `std::size_t` as value type
\tparam Distance a model of `ProtrusionDistance`
\tparam Border a model of `ProtrusionBorder`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh. Faces may be any polygons; there may be borders and several components.
\param segment_ids the segment of every face; written only if the function succeeds
\param number_of_segments the number of segments k, from 1 to the number of faces
\param distance the distance on the surface, for instance `Protrusion_segmentation::Geodesic_distance`
\param border the border method, for instance `Protrusion_segmentation::Histogram_method`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and a point type with
                   `x()`, `y()` and `z()` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
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
    \cgalParamType{a model of `ProtrusionSegmentationVisitor`}
    \cgalParamDefault{`Protrusion_segmentation::Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of segments, or 0 if the visitor stopped the function, or if the mesh has no faces and no
        number of segments is given; in both cases nothing is written

\throw std::invalid_argument if `number_of_segments` is 0 or larger than the number of faces, or if a
       coordinate is not finite

Complexity: with `Protrusion_segmentation::Geodesic_distance` a few shortest path computations per segment,
each about linear in the number of faces.
*/
template <typename FaceGraph,
          typename SegmentMap,
          typename Distance,
          typename Border,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t segmentation_via_protrusion_tips(const FaceGraph& tmesh,
                                             SegmentMap segment_ids,
                                             std::size_t number_of_segments,
                                             const Distance& distance,
                                             const Border& border,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::segment_mesh(tmesh, segment_ids, number_of_segments, distance,
                                                         border, np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into a body and as many protrusions as there are evident ones, with distances and a
border method of choice: the method stops by itself, the first criterion of Section III of the paper.

\param tmesh, segment_ids, distance, border, np as for the function with a number of segments, a
       distance and a border method
\return as for the function with a number of segments, a distance and a border method
*/
template <typename FaceGraph,
          typename SegmentMap,
          typename Distance,
          typename Border,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t segmentation_via_protrusion_tips(const FaceGraph& tmesh,
                                             SegmentMap segment_ids,
                                             const Distance& distance,
                                             const Border& border,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::segment_mesh(tmesh, segment_ids, std::nullopt, distance, border,
                                                         np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into `number_of_segments` segments with the default distance,
`Protrusion_segmentation::Geodesic_distance`, and the default border method,
`Protrusion_segmentation::Minimum_cut_method`.

\param tmesh, segment_ids, number_of_segments, np as for the function with a number of segments, a
       distance and a border method
\return as for the function with a number of segments, a distance and a border method
*/
template <typename FaceGraph, typename SegmentMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t segmentation_via_protrusion_tips(const FaceGraph& tmesh,
                                             SegmentMap segment_ids,
                                             std::size_t number_of_segments,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return segmentation_via_protrusion_tips(tmesh, segment_ids, number_of_segments,
                                          Protrusion_segmentation::Geodesic_distance(),
                                          Protrusion_segmentation::Minimum_cut_method(), np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

splits a surface mesh into a body and its evident protrusions with the default distance and border method.

\param tmesh, segment_ids, np as for the function with a number of segments, a
       distance and a border method
\return as for the function with a number of segments, a distance and a border method
*/
template <typename FaceGraph, typename SegmentMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t segmentation_via_protrusion_tips(const FaceGraph& tmesh,
                                             SegmentMap segment_ids,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return segmentation_via_protrusion_tips(tmesh, segment_ids, Protrusion_segmentation::Geodesic_distance(),
                                          Protrusion_segmentation::Minimum_cut_method(), np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

selects protrusion tips, Section III.C: the face with the largest sum of distances to all faces,
eq.&nbsp;(1), then again and again the face farthest from all tips so far, eq.&nbsp;(2).

In a mesh of several connected components, each tip is selected in the component of largest area per tip,
the new one counted.

\tparam OutputIterator a model of `OutputIterator` that accepts
                       `boost::graph_traits<FaceGraph>::%face_descriptor`

\param tmesh the mesh
\param number_of_tips the number of tips, at most the number of faces
\param tips where the faces at the tips are written, in the order of selection in each component; fewer than
            asked for if the remaining faces are at no distance from a tip
\param distance the distance on the surface
\param np an optional sequence of named parameters, among `vertex_point_map` and `random_seed` as for
          `segmentation_via_protrusion_tips()`

\return `tips`, advanced

\throw std::invalid_argument if there are more tips than faces, or if a coordinate is not finite
*/
template <typename FaceGraph,
          typename OutputIterator,
          typename Distance,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
OutputIterator protrusion_tips(const FaceGraph& tmesh,
                               std::size_t number_of_tips,
                               OutputIterator tips,
                               const Distance& distance,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::select_mesh_tips(tmesh, number_of_tips, tips, distance, np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

cuts off the protrusions of given tips, steps 3 and 4 of Section III.A: for tips of `protrusion_tips()`,
edited or picked by a user.

A tip for which no border is found, or that already lies in the protrusion of another one, makes no segment.

\tparam FaceRange a range of `boost::graph_traits<FaceGraph>::%face_descriptor`

\param tips the faces at the tips
\param tmesh, segment_ids, distance, border, np as for `segmentation_via_protrusion_tips()`

\return as for `segmentation_via_protrusion_tips()`

\throw std::invalid_argument if a face of `tips` is not in `tmesh`, or if a coordinate is not finite
*/
template <typename FaceGraph,
          typename FaceRange,
          typename SegmentMap,
          typename Distance,
          typename Border,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t segmentation_from_protrusion_tips(const FaceGraph& tmesh,
                                              const FaceRange& tips,
                                              SegmentMap segment_ids,
                                              const Distance& distance,
                                              const Border& border,
                                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::segment_mesh_from_tips(tmesh, tips, segment_ids, distance,
                                                                   border, np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

computes the hierarchy of nested protrusions with the default distance and border method: one call that
serves every number of segments.

For every k, the segmentation of the hierarchy is the one of `segmentation_via_protrusion_tips()`.

\param tmesh the mesh
\param maximum_number_of_segments where to stop, from 1 to the number of faces; the hierarchy ends earlier if
       no more borders are found
\param np an optional sequence of named parameters, among `vertex_point_map`, `random_seed` and `visitor` as
       for `segmentation_via_protrusion_tips()`

\return the hierarchy; an empty one if the visitor stopped the function

\throw std::invalid_argument if `maximum_number_of_segments` is 0 or larger than the number of faces, or if a
       coordinate is not finite
*/
template <typename FaceGraph, typename CGAL_NP_TEMPLATE_PARAMETERS>
Protrusion_segmentation::Segment_hierarchy protrusion_hierarchy(
  const FaceGraph& tmesh,
  std::size_t maximum_number_of_segments,
  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Protrusion_segmentation::internal::mesh_hierarchy(
    tmesh, maximum_number_of_segments, Protrusion_segmentation::Geodesic_distance(),
    Protrusion_segmentation::Minimum_cut_method(), np);
}

} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_H
