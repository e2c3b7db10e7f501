// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_HIERARCHY_H
#define CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_HIERARCHY_H

#include <CGAL/Protrusion_segmentation/Minimum_cut_method.h>
#include <CGAL/Protrusion_segmentation/Segment_hierarchy.h>
#include <CGAL/Protrusion_segmentation/internal/segment_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <optional>

namespace CGAL {

/*!
\ingroup PkgProtrusionSegmentationRef

computes the hierarchy of nested protrusions by `Protrusion_segmentation::Minimum_cut_method`: one call gives the
segmentations with every number of segments.

The segmentation with the largest number of segments is that of `segmentation_via_protrusion_tips()`. Those with fewer
segments join protrusions to their parents, so that all are nested: those whose borders have the least value are joined first.
`segmentation_via_protrusion_tips()` may find a better segmentation for a smaller number.

\tparam ConcurrencyTag, FaceGraph, Number, NamedParameters as for `segmentation_via_protrusion_tips()`

\param pmesh the mesh. Faces may be any polygons; there may be borders and several components.
\param maximum_number_of_segments the number of segments of the finest segmentation, from 1 to the number of faces; it
       has fewer if no more borders are found
\param np an optional sequence of named parameters, among `vertex_point_map`, `random_seed`, `face_patch_map` and `visitor` as for
       `segmentation_via_protrusion_tips()`. With `edge_is_constrained_map`, the call does not compile.

\return the hierarchy

\throw std::invalid_argument if `maximum_number_of_segments` is out of its range, or if a coordinate of a vertex with a
       face is not finite
\throw Protrusion_segmentation::Segmentation_stopped if the visitor stops the function

Complexity: that of `segmentation_via_protrusion_tips()` with `maximum_number_of_segments`.
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
  return Protrusion_segmentation::internal::mesh_hierarchy<ConcurrencyTag>(
    pmesh, maximum_number_of_segments, Protrusion_segmentation::Minimum_cut_method(), np);
}

/*!
\ingroup PkgProtrusionSegmentationRef

computes the hierarchy of nested protrusions by a method of choice.

\tparam ConcurrencyTag, FaceGraph, Number, NamedParameters as for the function without a method
\tparam Method as for `segmentation_via_protrusion_tips()`

\param method the method with its options and its distance
\param pmesh, maximum_number_of_segments, np as for the function without a method

\return the hierarchy

\throw std::invalid_argument as the function without a method, and if a distance of a user gives a number that is negative
       or no number
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
  return Protrusion_segmentation::internal::mesh_hierarchy<ConcurrencyTag>(
    pmesh, maximum_number_of_segments, method, np);
}

#ifndef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag,
          typename FaceGraph,
          typename Number,
          typename... Others>
Protrusion_segmentation::Segment_hierarchy protrusion_hierarchy(const FaceGraph&,
                                                                Number,
                                                                const Others&...)
{
  static_assert(sizeof...(Others) > 100,
                "what follows maximum_number_of_segments must be a method and then named parameters; a "
                "distance belongs to "
                "a method, as in Histogram_method(Landmark_geodesic_distance(0.1))");
  return {};
}
#endif

} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_PROTRUSION_HIERARCHY_H
